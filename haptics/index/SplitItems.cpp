#include "haptics/index/SplitItems.h"

#include <algorithm>
#include <array>
#include <limits>

namespace haptiv {
namespace {

using Items = std::span<SplitItem>;
constexpr std::size_t kBins = 16;
/// Larger groups are split along their longest axis: trying the others costs time and gains nothing there.
constexpr std::size_t kTryAllAxes = 512;

FloatBox nothing() noexcept {
  constexpr float far = std::numeric_limits<float>::max();
  return {{far, far, far}, {-far, -far, -far}};
}

void include(FloatBox& box, const FloatBox& other) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(box.low[i], other.low[i]);
    box.high[i] = std::max(box.high[i], other.high[i]);
  }
}

/// Twice the middle.
float middle(const SplitItem& item, std::size_t axis) noexcept {
  return item.box.low[axis] + item.box.high[axis];
}

FloatBox middles(std::span<const SplitItem> items) noexcept {
  FloatBox box = nothing();
  for (const SplitItem& item : items) {
    const std::array<float, 3> m{middle(item, 0), middle(item, 1), middle(item, 2)};
    include(box, {m, m});
  }
  return box;
}

std::size_t longestAxis(const FloatBox& box) noexcept {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (box.high[i] - box.low[i] > box.high[longest] - box.low[longest]) longest = i;
  }
  return longest;
}

/// Which of the slices along an axis an item's middle is in.
struct Slices {
  Slices(const FloatBox& range, std::size_t newAxis) noexcept
      : axis(newAxis), low(range.low[axis]), perLength(kBins / (double{range.high[axis]} - double{range.low[axis]})) {}
  std::size_t operator()(const SplitItem& item) const noexcept {
    return std::min(static_cast<std::size_t>((double{middle(item, axis)} - low) * perLength), kBins - 1);
  }
  std::size_t axis;
  double low;
  double perLength;
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  std::size_t axis = 0;
  std::size_t slices = 0;  ///< that go to the first group
};

/// The best place for a cut between the slices of one axis.
void tryAxis(Items items, const Slices& sliceOf, Split& best) noexcept {
  struct Bin {
    FloatBox box = nothing();
    std::size_t count = 0;
  };
  std::array<Bin, kBins> bins;
  for (const SplitItem& item : items) {
    Bin& bin = bins[sliceOf(item)];
    include(bin.box, item.box);
    ++bin.count;
  }
  std::array<double, kBins> costBehind{};  // of the slices from here on
  Bin behind;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    include(behind.box, bins[i].box);
    behind.count += bins[i].count;
    costBehind[i] = behind.count == 0 ? 0 : halfArea(behind.box) * static_cast<double>(behind.count);
  }
  Bin before;
  for (std::size_t i = 0; i + 1 < kBins; ++i) {
    include(before.box, bins[i].box);
    before.count += bins[i].count;
    if (before.count == 0 || before.count == items.size()) continue;
    const double cost = halfArea(before.box) * static_cast<double>(before.count) + costBehind[i + 1];
    if (cost < best.cost) best = {cost, sliceOf.axis, i + 1};
  }
}

}  // namespace

FloatBox boxAround(std::span<const SplitItem> items) noexcept {
  FloatBox box = nothing();
  for (const SplitItem& item : items) include(box, item.box);
  return box;
}

double halfArea(const FloatBox& box) noexcept {
  const double x = double{box.high[0]} - double{box.low[0]};
  const double y = double{box.high[1]} - double{box.low[1]};
  const double z = double{box.high[2]} - double{box.low[2]};
  return x * y + y * z + z * x + 1e-3 * (x * x + y * y + z * z);
}

std::size_t splitByArea(Items items) noexcept {
  const FloatBox range = middles(items);
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(range.high[axis] > range.low[axis])) continue;
    if (items.size() > kTryAllAxes && axis != longestAxis(range)) continue;
    tryAxis(items, Slices(range, axis), best);
  }
  if (best.slices == 0) return items.size() / 2;  // all on one spot
  const Slices sliceOf(range, best.axis);
  const auto second =
      std::partition(items.begin(), items.end(), [&](const SplitItem& item) { return sliceOf(item) < best.slices; });
  return static_cast<std::size_t>(second - items.begin());
}

std::size_t halve(Items items) noexcept {
  const std::size_t axis = longestAxis(middles(items));
  const auto half = static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), items.begin() + half, items.end(), [&](const SplitItem& a, const SplitItem& b) {
    const float ma = middle(a, axis), mb = middle(b, axis);
    return ma != mb ? ma < mb : a.index < b.index;
  });
  return items.size() / 2;
}

}  // namespace haptiv
