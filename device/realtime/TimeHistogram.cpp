#include "device/realtime/TimeHistogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace haptiv {
namespace {

constexpr int kBitsInOctave = 4;  // sixteen bins
static_assert(1 << kBitsInOctave == TimeHistogram::kBinsPerOctave);

}  // namespace

std::size_t TimeHistogram::binOf(std::int64_t time) noexcept {
  if (time < kBinsPerOctave) return static_cast<std::size_t>(std::max<std::int64_t>(time, 0));
  const int shift = std::bit_width(static_cast<std::uint64_t>(time)) - 1 - kBitsInOctave;
  // The leading digit is in the 16 to 31 that are left after the shift: each octave begins where the last one ended.
  const std::size_t bin = static_cast<std::size_t>(shift * kBinsPerOctave + (time >> shift));
  return std::min(bin, kBins - 1);
}

std::int64_t TimeHistogram::beginOf(std::size_t bin) noexcept {
  const auto number = static_cast<std::int64_t>(bin);
  if (number < 2 * kBinsPerOctave) return number;
  const std::int64_t shift = number / kBinsPerOctave - 1;
  return (number - shift * kBinsPerOctave) << shift;
}

void TimeHistogram::add(std::int64_t time) noexcept {
  std::atomic<std::uint64_t>& count = counts_[binOf(time)];
  count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (time > longest_.load(std::memory_order_relaxed)) longest_.store(time, std::memory_order_relaxed);
}

TimeDistribution TimeHistogram::distribution() const {
  TimeDistribution now;
  now.counts.reserve(kBins);
  for (const auto& count : counts_) {
    now.counts.push_back(count.load(std::memory_order_relaxed));
    now.total += now.counts.back();
  }
  now.longest = longest_.load(std::memory_order_relaxed);
  return now;
}

std::int64_t TimeDistribution::quantile(double part) const {
  if (total == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(total)));
  std::uint64_t sum = 0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    sum += counts[bin];
    if (sum > 0 && sum >= wanted) return std::min(TimeHistogram::beginOf(bin + 1) - 1, longest);
  }
  return longest;
}

}  // namespace haptiv
