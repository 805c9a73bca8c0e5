#pragma once

#include <cstdint>
#include <list>
#include <vector>

#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// Single ticks of a log, at random: reads blocks and keeps a few, so that a log of any length takes little memory.
/// Throws std::runtime_error where the log cannot be read; then the block is tried again the next time.
class LogReader {
 public:
  /// The log is not owned and must outlive the reader.
  explicit LogReader(const SessionLog& log);

  std::uint64_t count() const { return count_; }
  /// The tick with this index (not number: ticks may be missing), index < count().
  const TickRecord& at(std::uint64_t index);
  /// Index of the tick that is newest at `time` [ns]; 0 where there is none so early. Needs count() > 0.
  std::uint64_t indexAt(std::int64_t time);

  static constexpr std::uint64_t kBlock = 1000;  ///< ticks read at once
  static constexpr std::size_t kBlocksKept = 8;

 private:
  struct Block {
    std::uint64_t number = 0;
    std::vector<TickRecord> ticks;
  };
  const Block& block(std::uint64_t number);

  const SessionLog& log_;
  std::uint64_t count_;
  std::list<Block> kept_;  ///< the one used last comes first
};

}  // namespace haptiv
