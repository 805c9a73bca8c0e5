#include "scenegraph/compiling/PathIds.h"

#include <Inventor/SoPath.h>

namespace haptiv {

PathIds::Way PathIds::wayOn(Way way, const SoNode* next) {
  std::uint64_t x = way ^ reinterpret_cast<std::uintptr_t>(next);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

PathIds::Way PathIds::wayOf(const SoPath& path, int nodes) {
  const auto& full = static_cast<const SoFullPath&>(path);
  Way way = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(nodes); ++i) {
    const SoNode* node = full.getNode(static_cast<int>(i));
    if (i == last_.size() || last_[i].node != node) {
      last_.resize(i);
      last_.push_back({node, wayOn(way, node)});
    }
    way = last_[i].way;
  }
  return way;
}

PathIds::Way PathIds::wayOf(const SoPath& path) {
  return wayOf(path, static_cast<const SoFullPath&>(path).getLength());
}

PathIds::Way PathIds::wayToParent(const SoPath& path) {
  return wayOf(path, static_cast<const SoFullPath&>(path).getLength() - 1);
}

PathIds::Place PathIds::placeOf(Way way) {
  Place& next = places_[way];
  if (next == 0) {
    shapes_.push_back({way});
    next = static_cast<Place>(shapes_.size());
  }
  return next - 1;
}

ShapeId PathIds::meet(Place place) {
  Shape& shape = shapes_[place];
  if (shape.round != round_) {
    shape.round = round_;
    shape.times = 0;
  }
  const std::uint32_t time = shape.times++;
  ShapeId& id = time == 0 ? shape.first : repeats_[{shape.way, time}];
  if (id == 0) id = ++ids_;
  return id;
}

}  // namespace haptiv
