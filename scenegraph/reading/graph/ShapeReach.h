#pragma once

#include <Inventor/fields/SoMFInt32.h>

#include <cstdint>
#include <string>

class SoNode;

namespace haptiv {

/// How often an attribute (normal, colour, texture coordinate) changes along a shape.
enum class Per { shape, part, face, vertex };

/// How far a shape reaches into the lists that are in force.
struct ShapeReach {
  std::int64_t coordinates = 0;           ///< one more than the largest index of a coordinate
  std::int64_t vertices = 0;              ///< that it is made of, one after the other
  std::int64_t faces = 0;                 ///< polygons; triangles of a strip; lines of a line set
  std::int64_t parts = 0;                 ///< polygons; strips; segments of a line set
  const SoMFInt32* coordIndex = nullptr;  ///< of an indexed shape
  bool isLines = false;
  std::string fault;  ///< an index or count that means nothing; empty where there is none

  /// How many values of an attribute it needs.
  /// @param index  the attribute's own index field; null or without a value: it goes with the coordinates
  std::int64_t of(Per per, bool byIndex, const SoMFInt32* index) const;

  /// Whether an attribute is to go by an index that is not there.
  bool lacksIndex(Per per, bool byIndex, const SoMFInt32* index) const;
  /// Why an attribute's own indices do not fit the shape's coordIndex; empty where they do.
  std::string indexFault(Per per, bool byIndex, const SoMFInt32* index) const;

 private:
  std::string listFault(Per per, const SoMFInt32& index) const;
};

/// Of IndexedShape and its like: lists of indices that -1 ends.
ShapeReach reachOfIndices(const SoMFInt32& coordIndex, bool isLines, bool isStrips);

/// Of FaceSet, LineSet, TriangleStripSet, PointSet and QuadMesh; nothing for other nodes.
/// @param coordinates  how many are in force: a count of -1 takes all the rest
ShapeReach reachOfCounts(const SoNode* node, std::int64_t coordinates);

}  // namespace haptiv
