#pragma once

#include "scenegraph/judging/SceneJudge.h"

// The rules of SceneJudge, one a function. Each returns what it finds, in the order of the scene.

namespace haptiv {

/// Errors: the arm cannot reach the place where a session is to start.
Diagnostics judgeReachOfHome(const JudgedScene& judged);
/// A session starts with the ball in a wall: |distance| < radius.
Diagnostics judgeHomeInWall(const JudgedScene& judged);

/// Sizes that look like another unit: the felt scene against the arm's reach (a scene in millimetres), the ball's
/// radius against it, and the mass that the hand feels, m times the device's scale.
Diagnostics judgeUnits(const JudgedScene& judged);

/// Walls thinner than F / k, to where the device's peak force presses the ball.
Diagnostics judgeThickness(const JudgedScene& judged);

/// Walls and zones that the sampled admittance cannot render stably, k dt^2/m + 2 b dt/m >= 4, or whose natural
/// frequency (31) is above the bandwidth of the drives: k > m omega_d^2.
Diagnostics judgeStability(const JudgedScene& judged);

/// Zones out of the arm's reach, and zones wholly inside a wall.
Diagnostics judgeZonesInReach(const JudgedScene& judged);
/// Anchors outside of their zones.
Diagnostics judgeAnchors(const JudgedScene& judged);

/// Properties that share a label: logs and --set could not tell them apart.
Diagnostics judgeLabels(const JudgedScene& judged);

}  // namespace haptiv
