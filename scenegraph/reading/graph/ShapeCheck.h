#pragma once

#include "scenegraph/reading/graph/AttributesInForce.h"
#include "scenegraph/reading/graph/CrowdedPoints.h"
#include "scenegraph/reading/graph/IndexFaults.h"
#include "scenegraph/reading/graph/ListMending.h"
#include "scenegraph/reading/graph/ShapeReach.h"

class SoVertexShape;
class SoVRMLElevationGrid;
class SoVRMLIndexedLine;
class SoVRMLIndexedShape;

namespace haptiv {

/// Holds what shapes reach for (coordinates, normals, materials ...) against what there is.
class ShapeCheck {
 public:
  explicit ShapeCheck(IndexFaults& faults) : faults_(faults) {}

  /// Whether the node is a shape made of lists; then it has been checked, with what is in force where it stands.
  bool operator()(const SoNode* node, const AttributesInForce& state);

  /// What has to be done to lists of shapes of which only warnings tell.
  const ListMending& mending() const { return mending_; }

 private:
  bool checkIfShape(const SoNode* node, const AttributesInForce& state);
  void checkShape(const SoVertexShape& shape, AttributesInForce state);
  void checkShape(const SoVRMLIndexedShape& shape);
  void checkShape(const SoVRMLIndexedLine& shape);
  void checkShape(const SoVRMLElevationGrid& grid);
  /// An attribute without any value is made by Coin itself.
  void hold(const SoNode* node, const char* what, const ShapeReach& reach, const Attribute& attribute,
            const SoMFInt32* index);
  void hold(const SoNode* node, const char* what, std::int64_t needed, std::int64_t available);
  void holdCrowds(const SoNode* node, const ShapeReach& reach);
  /// Of a shape without indices; where it has normals, Coin makes none.
  void holdCrowds(const SoVertexShape& shape, const ShapeReach& reach, const AttributesInForce& state);
  void say(const SoNode* node, std::string message, Diagnostic::Severity severity = Diagnostic::Severity::error);

  IndexFaults& faults_;
  ListMending mending_;
  CrowdedPoints crowds_;
  bool isSound_ = true;  ///< the shape that is being checked, so far
};

}  // namespace haptiv
