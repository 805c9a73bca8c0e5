#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace haptiv {

/// How long something took, over many times: how often each bin was met, as it was at one moment.
struct TimeDistribution {
  std::vector<std::uint64_t> counts;  ///< of the bins of TimeHistogram
  std::uint64_t total = 0;
  std::int64_t longest = 0;  ///< [ns], exact

  /// The time [ns] that a part of all, 0 to 1, does not exceed: the upper end of its bin; 0 where there are none.
  std::int64_t quantile(double part) const;
};

/// Times in bins that grow with them, sixteen to an octave: a bin is a sixteenth as wide as the times in it. Its size
/// is fixed, so that the servo can write while the display reads.
class TimeHistogram {
 public:
  static constexpr int kBinsPerOctave = 16;
  static constexpr std::size_t kBins = 31 * kBinsPerOctave;  ///< up to 17 s; what is longer counts in the last one

  /// The bin of a time [ns]; of a negative one, the first.
  static std::size_t binOf(std::int64_t time) noexcept;
  /// The least time [ns] in a bin. Of `kBins`: the end of the last one.
  static std::int64_t beginOf(std::size_t bin) noexcept;

  /// Thread: one writer.  Realtime-safe: yes.
  void add(std::int64_t time) noexcept;
  /// Thread: any. What is added meanwhile may be in it or not.
  TimeDistribution distribution() const;

 private:
  std::array<std::atomic<std::uint64_t>, kBins> counts_{};
  std::atomic<std::int64_t> longest_ = 0;
};

}  // namespace haptiv
