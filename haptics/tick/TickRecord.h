#pragma once

#include <cstdint>

#include "device/HapticDevice.h"
#include "device/types.h"
#include "haptics/safety/Faults.h"
#include "haptics/safety/SessionStates.h"

namespace haptiv {

/// Everything of one tick: input, state and output. Trivially copyable: goes into the log's ring and to the display.
struct TickRecord {
  // When. Not part of the function's result: the servo loop fills these in.
  std::uint64_t tick = 0;         ///< grid points since the session's start
  std::int64_t time = 0;          ///< since the session's start [ns]
  std::int32_t wakeLateness = 0;  ///< [ns]
  std::int32_t computeTime = 0;   ///< [ns]
  std::uint32_t missedTicks = 0;  ///< grid points skipped so far
  // What came in.
  std::uint32_t sceneVersion = 0;
  DeviceReading reading;
  // What was made of it.
  JointVector jointAngles = JointVector::Zero();    ///< measured [rad]
  JointVector desiredAngles = JointVector::Zero();  ///< sent to the joint controller [rad]
  Vector3 position = Vector3::Zero();               ///< p_WT from the joint angles [m]
  Vector3 desiredPosition = Vector3::Zero();        ///< p_WT of the admittance [m]
  Vector3 desiredVelocity = Vector3::Zero();        ///< [m/s]
  Vector3 handForce = Vector3::Zero();              ///< of the hand on the ball, in W [N]
  Vector3 handTorque = Vector3::Zero();             ///< of the hand about the ball's centre, in W [N m]
  Vector3 environmentForce = Vector3::Zero();       ///< of the scene on the ball, in W [N]
  double penetration = 0;                           ///< deepest contact [m]
  std::int32_t contacts = 0;                        ///< walls touched
  std::int32_t zones = 0;                           ///< zones the ball is in
  std::int32_t deepestWall = -1;                    ///< index into HapticScene::walls, -1: none
  SessionState state = SessionState::idle;
  std::uint32_t faults = kNoFault;  ///< latched
  std::uint32_t clamps = 0;         ///< Clamp bits: what was held back
  double passivityEnergy = 0;       ///< taken in at the tool so far, by the observer [J]
  double passivityDamping = 0;      ///< that the passivity controller adds [N s/m]
  // What went out.
  DeviceCommand command;
};

}  // namespace haptiv
