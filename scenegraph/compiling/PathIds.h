#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "haptics/scene/HapticScene.h"
#include "scenegraph/compiling/FlatMap.h"

class SoNode;
class SoPath;

namespace haptiv {

/// Gives every shape of a scene graph the id that it had in the compilation before, by the nodes on the way to it.
/// Thread: GUI.
///
/// The way is known by a number of 64 bits that is made of its nodes. Should two ways ever have the same, they are
/// taken for one that is met twice: the ids still differ.
class PathIds {
 public:
  /// A compilation begins.
  void begin() { ++round_; }
  /// The id of a shape. A group may hold one node twice, and an array visits it often: each time that a compilation
  /// meets a path, the shape is another one.
  /// @param path   to the shape, or to the group that holds it ...
  /// @param below  ... and then the shape itself; else null
  ShapeId idOf(const SoPath& path, const SoNode* below = nullptr);

 private:
  struct Step {
    const SoNode* node = nullptr;
    std::uint64_t way = 0;  ///< from the root to this node
  };
  struct Shape {
    std::uint32_t round = 0;  ///< the compilation that met it last ...
    std::uint32_t times = 0;  ///< ... and how often
    ShapeId first = 0;        ///< its id when it is met first; 0: none yet
  };

  std::uint64_t wayOf(const SoPath& path);

  std::uint32_t round_ = 0;
  ShapeId ids_ = 0;
  FlatMap<Shape> shapes_;                                               ///< by their ways
  std::map<std::pair<std::uint64_t, std::uint32_t>, ShapeId> repeats_;  ///< of ways met again, and how often before
  std::vector<Step> last_;  ///< the path asked for last: the next starts alike
};

}  // namespace haptiv
