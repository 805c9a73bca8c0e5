#include "haptics/index/SplitItems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace haptiv {
namespace {

using Items = std::span<SplitItem>;
constexpr std::size_t kBins = 16;
/// Larger groups are split along their longest axis: trying the others costs time and gains nothing there.
constexpr std::size_t kTryAllAxes = 128;

double halfAreaOf(const WideBox& box) noexcept {
  const Eigen::Array3d d = box.high.head<3>().cast<double>() - box.low.head<3>().cast<double>();
  return d[0] * d[1] + d[1] * d[2] + d[2] * d[0] + 1e-3 * d.square().sum();
}

Eigen::Index longestAxis(const WideBox& box) noexcept {
  Eigen::Index longest = 0;
  (box.high - box.low).head<3>().maxCoeff(&longest);
  return longest;
}

/// To a 64th of a power of two: where the outermost item moves a little, the slices of a large group stay.
void roundOutwards(float& low, float& high) noexcept {
  int exponent = 0;
  std::frexp(high - low, &exponent);
  const float step = std::ldexp(1.0F, exponent - 7);
  const float first = step * std::floor(low / step), last = step * std::ceil(high / step);
  if (step > 0 && std::isfinite(last - first)) low = first, high = last;
}

/// Which of the slices along an axis an item's middle is in.
struct Slices {
  Slices(const WideBox& middles, Eigen::Index newAxis, std::size_t items) noexcept
      : axis(newAxis), low(middles.low[axis]) {
    float high = middles.high[axis];
    if (items > kTryAllAxes) roundOutwards(low, high);
    perLength = kBins / (high - low);
  }
  SplitChoice cutAfter(std::size_t slices) const noexcept {
    return {low, perLength, static_cast<std::uint8_t>(axis), static_cast<std::uint8_t>(slices)};
  }
  /// Whether there is any length to be cut.
  bool exist() const noexcept { return std::isfinite(perLength); }
  std::size_t operator()(const SplitItem& item) const noexcept {
    const float middle = item.box.low[axis] + item.box.high[axis];
    return std::min(static_cast<std::size_t>((middle - low) * perLength), kBins - 1);
  }
  Eigen::Index axis;
  float low;
  float perLength;
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  Eigen::Index axis = 0;
  std::size_t slices = 0;  ///< that go to the first group
};

/// The best place for a cut between the slices of one axis.
void tryAxis(Items items, const Slices& sliceOf, Split& best) noexcept {
  struct Bin {
    WideBox box;
    std::size_t count = 0;
    void include(const Bin& other) noexcept {
      box.include(other.box);
      count += other.count;
    }
    double cost() const noexcept { return count == 0 ? 0 : halfAreaOf(box) * static_cast<double>(count); }
  };
  std::array<Bin, kBins> bins;
  for (const SplitItem& item : items) {
    Bin& bin = bins[sliceOf(item)];
    bin.box.include(item.box);
    ++bin.count;
  }
  std::array<double, kBins> costBehind{};  // of the slices from here on
  Bin behind;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    behind.include(bins[i]);
    costBehind[i] = behind.cost();
  }
  Bin before;
  for (std::size_t i = 0; i + 1 < kBins; ++i) {
    before.include(bins[i]);
    if (before.count == 0 || before.count == items.size()) continue;
    const double cost = before.cost() + costBehind[i + 1];
    if (cost < best.cost) best = {cost, sliceOf.axis, i + 1};
  }
}

/// Both groups, boxes and all, in one pass.
template <typename GoesFirst>
SplitGroups partition(Items items, const SplitChoice& choice, GoesFirst&& goesFirst) noexcept {
  SplitGroups groups{{}, {}, choice};
  ItemGroup& first = groups.first;
  ItemGroup& second = groups.second;
  std::size_t begin = 0, end = items.size();
  while (begin < end) {
    if (goesFirst(items[begin])) {
      first.include(items[begin++]);
    } else {
      second.include(items[begin]);
      std::swap(items[begin], items[--end]);
    }
  }
  first.items = items.first(begin);
  second.items = items.subspan(begin);
  return groups;
}

SplitGroups cutInTwo(Items items) noexcept {
  const std::size_t half = items.size() / 2;
  return {ItemGroup::of(items.first(half)), ItemGroup::of(items.subspan(half)), {}};
}

}  // namespace

ItemGroup ItemGroup::of(Items items) noexcept {
  ItemGroup group;
  group.items = items;
  for (const SplitItem& item : items) group.include(item);
  return group;
}

void sortByIndex(Items items) noexcept {
  std::ranges::sort(items, {}, &SplitItem::index);
}

double ItemGroup::halfArea() const noexcept {
  return halfAreaOf(box);
}

SplitGroups splitByArea(const ItemGroup& group) noexcept {
  const Eigen::Index longest = longestAxis(group.middles);
  Split best;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (group.items.size() > kTryAllAxes && axis != longest) continue;
    const Slices slices(group.middles, axis, group.items.size());
    if (slices.exist()) tryAxis(group.items, slices, best);
  }
  if (best.slices == 0) {  // all on one spot
    sortByIndex(group.items);
    return cutInTwo(group.items);
  }
  const Slices sliceOf(group.middles, best.axis, group.items.size());
  return partition(group.items, sliceOf.cutAfter(best.slices),
                   [&](const SplitItem& item) { return sliceOf(item) < best.slices; });
}

SplitGroups halve(const ItemGroup& group) noexcept {
  const Eigen::Index axis = longestAxis(group.middles);
  const auto half = static_cast<std::ptrdiff_t>(group.items.size() / 2);
  std::nth_element(group.items.begin(), group.items.begin() + half, group.items.end(),
                   [&](const SplitItem& a, const SplitItem& b) {
                     const float ma = a.middle()[axis], mb = b.middle()[axis];
                     return ma != mb ? ma < mb : a.index() < b.index();
                   });
  return cutInTwo(group.items);
}

}  // namespace haptiv
