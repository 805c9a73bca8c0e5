#pragma once

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"
#include "scenegraph/Diagnostic.h"
#include "scenegraph/compiling/ShapeOrigin.h"

namespace haptiv {

/// What is judged: a valid scene on a device.
struct JudgedScene {
  const HapticScene& scene;
  const SceneOrigins& origins;
  const DeviceDescription& device;
  double rate = 1000;  ///< ticks a second [Hz]

  double period() const { return 1 / rate; }
};

/// Judges a scene as a haptician would: what can be computed and can still not be felt as it is meant. The rules, each
/// with its formula, are in docs/check.md and in Rules.h. A rule that finds much tells the first of it and how much
/// more there is. The diagnostics have node and source, not file and line. Takes time in the number of shapes.
Diagnostics judgeScene(const JudgedScene& judged);

}  // namespace haptiv
