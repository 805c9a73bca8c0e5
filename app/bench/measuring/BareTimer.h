#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "haptics/servo/ServoPace.h"

namespace haptiv {

/// The floor that the machine sets: a thread that asks for the same scheduling as the servo's and waits for the same
/// deadlines in the same way, and does nothing else. A deadline that it misses was taken by the machine, not by a tick.
class BareTimer {
 public:
  explicit BareTimer(const ServoPace& pace);
  ~BareTimer();
  BareTimer(const BareTimer&) = delete;
  BareTimer& operator=(const BareTimer&) = delete;

  std::uint64_t ticks() const { return ticks_; }  ///< grid points so far, missed ones included
  std::uint64_t missed() const { return missed_; }

 private:
  void run() noexcept;

  ServoPace pace_;
  std::atomic<bool> running_ = true;
  std::atomic<std::uint64_t> ticks_ = 0, missed_ = 0;
  std::thread thread_;
};

}  // namespace haptiv
