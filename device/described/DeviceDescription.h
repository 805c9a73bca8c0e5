#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "device/HapticDevice.h"
#include "device/Homing.h"
#include "device/described/ArmBodies.h"
#include "device/described/ChainGeometry.h"
#include "device/described/ControlSettings.h"
#include "device/described/DeltaGeometry.h"
#include "device/described/HandModel.h"
#include "device/described/HandleSensor.h"
#include "device/described/JointDrives.h"
#include "device/described/LinkLengths.h"
#include "device/described/RedundancySettings.h"
#include "device/described/SafetyThresholds.h"
#include "device/types.h"

namespace haptiv {

/// What a device measures and what it is told, by which it can be driven.
enum class DeviceType : std::uint8_t {
  admittance,  ///< senses the hand's force at the handle; its drives follow rates or torques
  impedance,   ///< has no force sensor, and drives that follow torques alone: light, and moved by the hand
};

/// Everything the program knows of one device: data, never code.
///
/// Read from a TOML file with `schema = 1`: docs/device.md tells every key.
struct DeviceDescription {
  std::string name = "vishard10";
  DeviceType type = DeviceType::admittance;
  LinkLengths links;                   ///< of VISHARD10
  ChainGeometry chain;                 ///< of any other serial arm; without joints the arm is a VISHARD10 ...
  std::optional<DeltaGeometry> delta;  ///< ... or a parallel arm
  FalconWiring falcon;                 ///< of a parallel arm that is a Novint Falcon
  Pose tool;                           ///< X_CT: the tool, in the frame of the wrist centre
  ArmBodies bodies;                    ///< of the links; empty where they are not known
  JointDrives drives;
  EncoderZero encoders;
  HandleSensor sensor;
  HandModel hand;
  ControlSettings control;
  RedundancySettings redundancy;
  SafetyThresholds safety;
  JointVector homeAngles = JointVector::Zero();  ///< gives orientation and elbow side at the start of a session
  std::string text;                              ///< the file it came from, for the session log

  bool isVishard10() const { return chain.joints.empty() && !delta; }
  int jointCount() const {
    if (delta) return DeltaGeometry::kLegs;
    return chain.joints.empty() ? kJointCount : static_cast<int>(chain.joints.size());
  }

  /// Joint angles [rad] that the encoders report. Realtime-safe: yes.
  JointVector jointAngles(const DeviceReading& reading) const noexcept;
  /// Counts that the encoders report at these joint angles [rad], to the nearest. Beyond 32 bits: the end of them.
  PoseCounts countsAt(const JointVector& angles) const noexcept;
  /// Wrench of the hand on the handle, in T. Realtime-safe: yes.
  Wrench handleWrench(const DeviceReading& reading) const noexcept;
};

/// Parses a description. Throws std::runtime_error "NAME:LINE:COLUMN: what, and what to do" on syntax errors,
/// unknown keys, wrong types, wrong array lengths and impossible values. Missing keys keep their defaults; schema must
/// be there. Never crashes or hangs on hostile text.
DeviceDescription parseDeviceDescription(std::string_view toml, const std::string& sourceName);

/// Finds a description: one of the built-in names ("vishard10"), or a path to a TOML file; a relative one is
/// relative to the folder of `namedIn`, the scene that names it and in whose folder it must be (empty: any folder).
/// Throws std::runtime_error that lists the built-in names when there is none.
DeviceDescription loadDeviceDescription(const std::string& nameOrPath, const std::string& namedIn = {});

}  // namespace haptiv
