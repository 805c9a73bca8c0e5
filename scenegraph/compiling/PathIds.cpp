#include "scenegraph/compiling/PathIds.h"

#include <Inventor/SoPath.h>

namespace haptiv {
namespace {

constexpr std::size_t kFirstSize = 1024;

std::size_t mixed(const SoNode* node, std::uint32_t above) {
  std::uint64_t x = reinterpret_cast<std::uintptr_t>(node) + 0x9e3779b97f4a7c15U * (above + 1U);
  x = (x ^ (x >> 31)) * 0xbf58476d1ce4e5b9U;
  return x ^ (x >> 29);
}

}  // namespace

PathIds::PathIds() : table_(kFirstSize), shapes_(1) {}

PathIds::Step& PathIds::slot(const SoNode* node, Place above) {
  for (std::size_t at = mixed(node, above);; ++at) {
    Step& step = table_[at & (table_.size() - 1)];
    if (step.node == nullptr || (step.node == node && step.above == above)) return step;
  }
}

void PathIds::grow() {
  std::vector<Step> before(2 * table_.size());
  before.swap(table_);
  for (const Step& step : before) {
    if (step.node != nullptr) slot(step.node, step.above) = step;
  }
}

PathIds::Place PathIds::placeBelow(const SoNode* node, Place above) {
  Step& step = slot(node, above);
  if (step.node != nullptr) return step.place;
  const auto place = static_cast<Place>(shapes_.size());
  step = {node, above, place};
  shapes_.emplace_back();
  if (shapes_.size() > table_.size() / 2) grow();
  return place;
}

PathIds::Place PathIds::placeOf(const SoPath& path) {
  const auto& full = static_cast<const SoFullPath&>(path);
  const auto length = static_cast<std::size_t>(full.getLength());
  Place above = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const SoNode* node = full.getNode(static_cast<int>(i));
    if (i == last_.size() || last_[i].node != node) {
      last_.resize(i);
      last_.push_back({node, above, placeBelow(node, above)});
    }
    above = last_[i].place;
  }
  return above;
}

ShapeId PathIds::idOf(const SoPath& path) {
  const Place place = placeOf(path);
  Shape& shape = shapes_[place];
  if (shape.round != round_) {
    shape.round = round_;
    shape.times = 0;
  }
  const std::uint32_t time = shape.times++;
  ShapeId& id = time == 0 ? shape.first : repeats_[{place, time}];
  if (id == 0) id = ++ids_;
  return id;
}

}  // namespace haptiv
