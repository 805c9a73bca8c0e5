#pragma once

#include <memory>

#include "haptics/scene/HapticScene.h"
#include "scenegraph/compiling/ShapeOrigin.h"

class SbMatrix;

namespace haptiv {

class SoHapticProperty;

/// A mesh as a shape of the scene.
Shape shapeOf(std::shared_ptr<const TriangleMesh> mesh);

/// A shape that is felt as a property says.
struct FeltShape {
  ShapeId id = 0;
  const SoNode* node = nullptr;
  const SoHapticProperty& property;
  const SbMatrix& toW;  ///< from the shape's coordinates: where a spring is anchored
};

/// Adds it to the walls or zones of a scene, and where it comes from to the scene's origins.
void addFelt(const FeltShape& felt, Shape shape, HapticScene& scene, SceneOrigins& origins);

}  // namespace haptiv
