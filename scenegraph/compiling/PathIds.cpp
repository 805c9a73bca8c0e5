#include "scenegraph/compiling/PathIds.h"

#include <Inventor/SoPath.h>

namespace haptiv {
namespace {

std::uint64_t wayOn(std::uint64_t way, const SoNode* node) {
  std::uint64_t x = way ^ reinterpret_cast<std::uintptr_t>(node);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

std::uint64_t PathIds::wayOf(const SoPath& path) {
  const auto& full = static_cast<const SoFullPath&>(path);
  const auto length = static_cast<std::size_t>(full.getLength());
  std::uint64_t way = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const SoNode* node = full.getNode(static_cast<int>(i));
    if (i == last_.size() || last_[i].node != node) {
      last_.resize(i);
      last_.push_back({node, wayOn(way, node)});
    }
    way = last_[i].way;
  }
  return way;
}

ShapeId PathIds::idOf(const SoPath& path, const SoNode* below) {
  std::uint64_t way = wayOf(path);
  if (below) way = wayOn(way, below);
  Shape& shape = shapes_[way];
  if (shape.round != round_) {
    shape.round = round_;
    shape.times = 0;
  }
  const std::uint32_t time = shape.times++;
  ShapeId& id = time == 0 ? shape.first : repeats_[{way, time}];
  if (id == 0) id = ++ids_;
  return id;
}

}  // namespace haptiv
