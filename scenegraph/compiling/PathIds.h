#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "haptics/HapticScene.h"

class SoNode;
class SoPath;

namespace haptiv {

/// Gives every shape of a scene graph the id that it had in the compilation before, by the nodes on the way to it.
/// Thread: GUI.
///
/// A node at its place below others is a place; places form a tree of all paths met so far. One look-up a node in a
/// flat hash table: scenes hold a hundred thousand shapes, and an edit compiles them all.
class PathIds {
 public:
  PathIds();

  /// A compilation begins.
  void begin() { ++round_; }
  /// The id of the shape at the end of a path. A group may hold one node twice, and an array visits it often: each
  /// time that a compilation meets a path, the shape is another one.
  ShapeId idOf(const SoPath& path);

 private:
  using Place = std::uint32_t;  ///< 0: the place above the root
  struct Step {
    const SoNode* node = nullptr;  ///< null: nothing stands here
    Place above = 0;
    Place place = 0;
  };
  struct Shape {
    std::uint32_t round = 0;  ///< the compilation that met it last ...
    std::uint32_t times = 0;  ///< ... and how often
    ShapeId first = 0;        ///< its id when it is met first; 0: none yet
  };

  Place placeOf(const SoPath& path);
  Step& slot(const SoNode* node, Place above);
  Place placeBelow(const SoNode* node, Place above);
  void grow();

  std::vector<Step> table_;  ///< open addressing; a power of two
  std::uint32_t round_ = 0;
  ShapeId ids_ = 0;
  std::vector<Shape> shapes_;                                   ///< of each place
  std::map<std::pair<Place, std::uint32_t>, ShapeId> repeats_;  ///< ids of places met again, and how often before
  std::vector<Step> last_;                                      ///< the path asked for last: the next one starts alike
};

}  // namespace haptiv
