#pragma once

#include <cmath>
#include <cstdint>

namespace haptiv {

/// The absolute times at which ticks are due: start, start + period, ... Pure arithmetic, without a clock.
/// Every deadline is computed from the start, so that no rounding adds up.
class TickGrid {
 public:
  /// @param start  time of grid point 0 [ns]
  /// @param rate   grid points per second [Hz]
  TickGrid(std::int64_t start, double rate) : start_(start), period_(1e9 / rate) {}

  /// Index of the tick that is due, counted from 0.
  std::uint64_t index() const noexcept { return index_; }
  /// When it is due [ns].
  std::int64_t deadline() const noexcept { return timeOf(index_); }
  /// When a grid point is due [ns].
  std::int64_t timeOf(std::uint64_t index) const noexcept {
    return start_ + std::llround(static_cast<double>(index) * period_);
  }

  /// After the tick that was due has run: on to the first grid point that is not yet past.
  /// @param now  [ns]
  /// @return     how many grid points were skipped
  std::uint32_t advance(std::int64_t now) noexcept {
    const std::uint64_t next = index_ + 1;
    index_ = next;
    if (now > deadline()) {
      index_ = static_cast<std::uint64_t>(std::ceil(static_cast<double>(now - start_) / period_));
      if (index_ < next) index_ = next;
      if (deadline() < now) ++index_;
    }
    return static_cast<std::uint32_t>(index_ - next);
  }

 private:
  std::int64_t start_;
  double period_;
  std::uint64_t index_ = 0;
};

}  // namespace haptiv
