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
  using Way = std::uint64_t;    ///< from the root to a node
  using Place = std::uint32_t;  ///< names a shape's way, for as long as this lives

  static Way wayOn(Way way, const SoNode* next);

  /// A compilation begins.
  void begin() { ++round_; }
  Way wayOf(const SoPath& path);
  /// The same without the last node.
  Way wayToParent(const SoPath& path);
  Place placeOf(Way way);
  /// The id of the shape that the compilation meets there. A group may hold one node twice, and an array visits it
  /// often: each time that a place is met, the shape is another one.
  ShapeId meet(Place place);
  /// Of the shape at the end of a path.
  ShapeId idOf(const SoPath& path) { return meet(placeOf(wayOf(path))); }

 private:
  struct Step {
    const SoNode* node = nullptr;
    Way way = 0;  ///< from the root to this node
  };
  struct Shape {
    Way way = 0;
    std::uint32_t round = 0;  ///< the compilation that met it last ...
    std::uint32_t times = 0;  ///< ... and how often
    ShapeId first = 0;        ///< its id when it is met first; 0: none yet
  };

  Way wayOf(const SoPath& path, int nodes);

  std::uint32_t round_ = 0;
  ShapeId ids_ = 0;
  std::vector<Shape> shapes_;                                 ///< by their places
  FlatMap<Place> places_;                                     ///< by their ways, one more each; 0: none yet
  std::map<std::pair<Way, std::uint32_t>, ShapeId> repeats_;  ///< of ways met again, and how often before
  std::vector<Step> last_;                                    ///< the path asked for last: the next starts alike
};

}  // namespace haptiv
