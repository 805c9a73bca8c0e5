#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "device/control/ControlChoice.h"
#include "device/control/ResolutionChoice.h"
#include "device/types.h"
#include "haptics/scene/ShapeIndex.h"
#include "haptics/shapes/Shape.h"

namespace haptiv {

/// Names a felt shape across edits: the same shape keeps its id when the scene is compiled again.
using ShapeId = std::uint32_t;

/// How a surface feels: the wall's law, eqs. (26), (27).
struct SurfaceProperties {
  double stiffness = 2000;     ///< [N/m]
  double damping = 20;         ///< [N s/m], only while moving in
  double hysteresis = 0;       ///< [m]
  double staticFriction = 0;   ///< [1]
  double dynamicFriction = 0;  ///< [1]
  /// Damping while moving out too, which sticks: to compare with, `haptiv bench wall`. Not of the .iv, nor of a log.
  bool dampsOutwards = false;
};

/// A shape that keeps the tool out.
struct Wall {
  ShapeId id = 0;
  Shape shape;
  SurfaceProperties surface;
};

/// A shape in which the tool feels a medium or a spring.
struct Zone {
  enum class Kind : std::uint8_t { viscous, spring, rubberBand };
  ShapeId id = 0;
  Kind kind = Kind::viscous;
  Shape shape;
  double damping = 15;               ///< viscous: [N s/m]
  double stiffness = 150;            ///< spring, rubber band: [N/m]
  double restLength = 0;             ///< spring, rubber band: [m]; the band pulls only beyond it
  Vector3 anchor = Vector3::Zero();  ///< spring, rubber band: p_WA [m]
};

/// The ball that the hand moves.
struct Tool {
  double mass = 2;                 ///< [kg]
  double damping = 5;              ///< b_free of eq. (28) [N s/m]
  double radius = 0.01;            ///< [m]
  Vector3 home = Vector3::Zero();  ///< p_WT at the start of a session [m]
};

/// Where the device stands in the scene: p_WT = p_WB + scale R_WB p_BT.
struct DevicePlacement {
  std::string description = "vishard10";
  Vector3 position = Vector3::Zero();      ///< p_WB [m]
  Matrix3 rotation = Matrix3::Identity();  ///< R_WB
  double scale = 1;                        ///< scene metres per device metre
};

/// All that can be felt, flat: what the servo reads of a scene. Immutable once published
/// (as shared_ptr<const HapticScene>); compiled from the scene graph, or read back from a log.
struct HapticScene {
  std::uint32_t version = 0;  ///< counts the compilations within a session
  Tool tool;
  DevicePlacement device;
  /// How the operator wants the redundancy resolved; without a choice, as the device description says. Not of the .iv.
  std::optional<ResolutionChoice> resolution;
  /// How the operator wants the arm driven; without a choice, as the device description says. Not of the .iv.
  std::optional<ControlChoice> control;
  std::vector<Wall> walls;
  std::vector<Zone> zones;
  ShapeIndex wallIndex;  ///< derived by computeBounds
  ShapeIndex zoneIndex;  ///< derived by computeBounds
  MeshIndex meshIndex;   ///< derived by computeBounds
};

/// Makes the indices by which the servo finds what is near. Whoever builds a scene calls this last; where it was
/// forgotten (the numbers do not match), every shape is measured in every tick: slow, and right all the same.
void computeBounds(HapticScene& scene);

}  // namespace haptiv
