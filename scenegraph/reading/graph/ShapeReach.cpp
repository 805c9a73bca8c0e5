#include "scenegraph/reading/graph/ShapeReach.h"

#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoPointSet.h>
#include <Inventor/nodes/SoQuadMesh.h>
#include <Inventor/nodes/SoTriangleStripSet.h>

#include <algorithm>

namespace haptiv {
namespace {

std::int64_t largestReach(const SoMFInt32& indices) {
  const int32_t* values = indices.getValues(0);
  return indices.getNum() > 0 ? std::int64_t{*std::max_element(values, values + indices.getNum())} + 1 : 0;
}

/// Coin takes an index that begins with -1, the default, for none.
bool hasValues(const SoMFInt32* index) {
  return index && index->getNum() > 0 && (*index)[0] >= 0;
}

enum class PieceKind { faces, strips, lines };

/// One polygon, strip or line of so many vertices.
void addPiece(ShapeReach& reach, PieceKind kind, std::int64_t vertices) {
  reach.vertices += vertices;
  const std::int64_t inner = std::max<std::int64_t>(0, vertices - (kind == PieceKind::lines ? 1 : 2));
  reach.faces += kind == PieceKind::strips ? inner : 1;
  reach.parts += kind == PieceKind::lines ? inner : 1;
}

ShapeReach reachOfPieces(PieceKind kind, std::int64_t start, const SoMFInt32& counts, std::int64_t coordinates) {
  ShapeReach reach;
  for (int i = 0; i < counts.getNum(); ++i) {
    const std::int64_t used = start + reach.vertices;
    if (counts[i] < -1)
      reach.fault = "numVertices holds " + std::to_string(counts[i]) + ": write a count, or -1 for all";
    if (counts[i] == -1) addPiece(reach, kind, std::max<std::int64_t>(0, coordinates - used));
    if (counts[i] > 0) addPiece(reach, kind, counts[i]);
  }
  reach.coordinates = start + reach.vertices;
  return reach;
}

ShapeReach reachOfMesh(const SoQuadMesh& mesh, std::int64_t start) {
  const std::int64_t columns = mesh.verticesPerRow.getValue();
  const std::int64_t rows = mesh.verticesPerColumn.getValue();
  ShapeReach reach;
  if (columns < 1 || rows < 1) {
    reach.fault = "verticesPerRow and verticesPerColumn are " + std::to_string(columns) + " and " +
                  std::to_string(rows) + ": write 1 or more";
    return reach;
  }
  reach.vertices = columns * rows;
  reach.faces = (columns - 1) * (rows - 1);
  reach.parts = rows - 1;
  reach.coordinates = start + reach.vertices;
  return reach;
}

}  // namespace

std::int64_t ShapeReach::of(Per per, bool byIndex, const SoMFInt32* index) const {
  if (per == Per::shape) return std::min<std::int64_t>(1, vertices);
  if (byIndex && coordIndex && hasValues(index)) return largestReach(*index);
  switch (per) {
    case Per::vertex:
      return byIndex && coordIndex ? coordinates : vertices;
    case Per::face:
      return faces;
    default:
      return parts;
  }
}

bool ShapeReach::lacksIndex(Per per, bool byIndex, const SoMFInt32* index) const {
  const bool goesByPieces = (per == Per::face || per == Per::part) && !isLines;
  return goesByPieces && byIndex && coordIndex && index && vertices > 0 && !hasValues(index);
}

std::string ShapeReach::indexFault(Per per, bool byIndex, const SoMFInt32* index) const {
  if (per == Per::shape || !byIndex || !coordIndex || !index || vertices == 0 || !hasValues(index)) return {};
  return listFault(per, *index);
}

// Coin goes through an index of vertices in step with coordIndex, and through one of faces or parts by itself.
std::string ShapeReach::listFault(Per per, const SoMFInt32& index) const {
  const std::int64_t pieces = per == Per::face ? faces : parts;
  const std::int64_t steps = per == Per::vertex ? coordIndex->getNum() : pieces;
  for (std::int64_t i = 0; i < steps; ++i) {
    const int at = static_cast<int>(i);
    if (per == Per::vertex && (*coordIndex)[at] < 0) continue;
    if (i >= index.getNum()) return "has fewer indices than the shape asks for: add the missing ones";
    if (index[at] < 0)
      return "has index " + std::to_string(index[at]) + " where the shape goes on: keep it in step with coordIndex";
  }
  return {};
}

ShapeReach reachOfIndices(const SoMFInt32& coordIndex, bool isLines, bool isStrips) {
  const PieceKind kind = isLines ? PieceKind::lines : isStrips ? PieceKind::strips : PieceKind::faces;
  ShapeReach reach;
  reach.coordIndex = &coordIndex;
  reach.isLines = isLines;
  reach.coordinates = largestReach(coordIndex);
  const int32_t* values = coordIndex.getValues(0);
  std::int64_t piece = 0;
  for (int i = 0; i < coordIndex.getNum(); ++i) {
    if (values[i] < -1)
      reach.fault = "coordIndex holds " + std::to_string(values[i]) + ": write an index, or -1 to end";
    if (values[i] >= 0) ++piece;
    if ((values[i] < 0 || i + 1 == coordIndex.getNum()) && piece > 0) {
      addPiece(reach, kind, piece);
      piece = 0;
    }
  }
  return reach;
}

ShapeReach reachOfCounts(const SoNode* node, std::int64_t coordinates) {
  const auto* plain = dynamic_cast<const SoNonIndexedShape*>(node);
  if (!plain) return {};
  const std::int64_t start = plain->startIndex.getValue();
  ShapeReach reach;
  if (const auto* faces = dynamic_cast<const SoFaceSet*>(node)) {
    reach = reachOfPieces(PieceKind::faces, start, faces->numVertices, coordinates);
  } else if (const auto* strips = dynamic_cast<const SoTriangleStripSet*>(node)) {
    reach = reachOfPieces(PieceKind::strips, start, strips->numVertices, coordinates);
  } else if (const auto* lines = dynamic_cast<const SoLineSet*>(node)) {
    reach = reachOfPieces(PieceKind::lines, start, lines->numVertices, coordinates);
  } else if (const auto* mesh = dynamic_cast<const SoQuadMesh*>(node)) {
    reach = reachOfMesh(*mesh, start);
  } else if (const auto* points = dynamic_cast<const SoPointSet*>(node)) {
    const std::int64_t count = points->numPoints.getValue();
    reach.vertices = reach.faces = reach.parts = count < 0 ? std::max<std::int64_t>(0, coordinates - start) : count;
    reach.coordinates = start + reach.vertices;
  }
  if (start < 0) reach.fault = "startIndex is " + std::to_string(start) + ": write 0 or more";
  return reach;
}

}  // namespace haptiv
