#pragma once

#include <cstdint>

#include "scenegraph/reading/graph/ShapeReach.h"

class SoMFVec3f;
class SoMField;
class SoNode;

namespace haptiv {

/// How many values of one attribute are in force, and how a shape goes through them.
struct Attribute {
  std::int64_t count = 0;
  Per per = Per::vertex;
  bool byIndex = true;
  const SoMField* values = nullptr;  ///< the list itself; null: Coin's own value
};

/// What a shape takes its vertices from, at one place of the graph: Coin's elements, as counts.
struct AttributesInForce {
  std::int64_t coordinates = 0;
  const SoMFVec3f* points = nullptr;  ///< the coordinates themselves; null: there are none, or they have four numbers
  Attribute normals;
  Attribute materials{1, Per::shape, false, nullptr};
  Attribute textureCoordinates;

  /// Takes over what a node sets; other nodes change nothing.
  void update(const SoNode* node);
};

}  // namespace haptiv
