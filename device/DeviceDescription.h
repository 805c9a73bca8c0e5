#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "device/HapticDevice.h"
#include "device/Homing.h"
#include "device/control/ControlChoice.h"
#include "device/dynamics/ArmBodies.h"
#include "device/kinematics/ChainGeometry.h"
#include "device/kinematics/DeltaGeometry.h"
#include "device/redundancy/RedundancySettings.h"
#include "device/types.h"

namespace haptiv {

/// The arm's links [m], as in Table I of the paper.
struct LinkLengths {
  double scara = 0.25;         ///< l1 = l2 = l3 = l4
  double forearm = 0.47;       ///< l5h, and back again l8
  double lift = 0.212;         ///< l6 = l7
  double scaraHeight = 0.71;   ///< l5v: the SCARA plane's height above joint 6; for drawing only
  double wristBracket = 0.15;  ///< l9 = l10; for drawing only
};

/// The drives of all joints; each vector has one entry a joint.
struct JointDrives {
  JointVector gearRatio = JointVector::Constant(100);       ///< motor turns per joint turn
  JointVector countsPerTurn = JointVector::Constant(4096);  ///< encoder counts per motor turn
  JointVector rateLimit = JointVector::Constant(6.28);      ///< [rad/s]
  JointVector torqueLimit = JointVector::Constant(60);      ///< [N m]
  JointVector inertia = JointVector::Constant(1);           ///< of the rotors, behind their gears [kg m^2]
  JointVector bandwidth = JointVector::Constant(400);       ///< of the drive's velocity loop [rad/s]
  JointVector viscousFriction = JointVector::Zero();        ///< at the joint [N m s/rad]
  JointVector coulombFriction = JointVector::Zero();        ///< at the joint [N m]
  /// Of motors that are bypassed, at the joint [N m s/rad]; within torqueLimit.
  JointVector brakeDamping = JointVector::Constant(40);
  /// Dry friction more, at the joint, while the motors brake [N m]: it holds the arm's weight.
  JointVector brakeFriction = JointVector::Zero();

  /// Encoder counts per radian of the joint.
  JointVector countsPerRadian() const;
};

/// What the encoders' counts mean, found by `haptiv device home`; each vector has one entry a joint.
struct EncoderZero {
  JointVector zero = JointVector::Zero();       ///< counts at the joint's zero, whole numbers
  JointVector reference = JointVector::Zero();  ///< the pose into which the arm is set for homing [rad]
};

/// The six-axis sensor at the handle. What the hand does to it is, in N and N m, in T,
///   wrench = matrix (resolution counts - bias)
struct HandleSensor {
  double forceResolution = 0.02;    ///< [N] per count
  double torqueResolution = 0.001;  ///< [N m] per count
  double forceNoise = 0.02;         ///< standard deviation [N]
  double torqueNoise = 0.0005;      ///< standard deviation [N m]
  double forceRange = 400;          ///< [N], saturates beyond
  double torqueRange = 30;          ///< [N m], saturates beyond
  double bandwidth = 50'265;        ///< of its low-pass [rad/s]: 8 kHz
  Vector6 bias = Vector6::Zero();   ///< what it says of an untouched handle, before the matrix [N], [N m]
  Matrix6 matrix = Matrix6::Identity();

  Vector6 resolution() const noexcept;                      ///< of each axis, per count [N], [N m]
  Vector6 range() const noexcept;                           ///< of each axis [N], [N m]
  std::array<std::int16_t, 6> lastCounts() const noexcept;  ///< at the end of each axis' range
  /// What the counts say before bias and matrix [N], [N m]. Realtime-safe: yes.
  Vector6 raw(const std::array<std::int16_t, 6>& counts) const noexcept;
};

/// The simulated operator's arm and grip: HumanHand tells how they work together.
struct HandModel {
  double stiffness = 400;       ///< from where the hand wants to be to the handle, arm and grip together [N/m]
  double damping = 20;          ///< of the arm [N s/m]
  double peakForce = 170;       ///< [N], no arm pulls harder
  double bandwidth = 40;        ///< of the low-pass by which it follows its own intent [rad/s]
  double mass = 1.8;            ///< of hand and forearm as far as they move along [kg]
  double gripStiffness = 3000;  ///< between hand and handle [N/m]; more than stiffness
  double gripDamping = 90;      ///< [N s/m]
  double gripStrength = 250;    ///< [N], beyond it the hand slips off
  double turnStiffness = 3;     ///< by which it holds the handle's orientation [N m/rad]
  double turnDamping = 0.15;    ///< [N m s/rad]
  double peakTorque = 8;        ///< [N m]
};

/// How the host drives the joints.
struct ControlSettings {
  ControlChoice choice;                ///< where the operator has not chosen
  double driftGain = 50;               ///< closed-loop correction of the inverse kinematics [1/s]
  double jointGain = 60;               ///< joint controller: rate per position error [1/s]
  double singularityDamping = 0.05;    ///< largest damping mu of the pseudoinverse
  double singularityThreshold = 0.01;  ///< manipulability [m^3] below which damping sets in
  double trackingErrorLimit = 0.05;    ///< [rad] between desired and measured joint angle; beyond: fault
  double trackingFrequency = 120;      ///< natural frequency of that error under computed torque [rad/s]
  double trackingDampingRatio = 1;     ///< of the same
  double velocityBandwidth = 1000;     ///< of the low-pass behind the differences of encoder angles [rad/s]
  double rotationalInertia = 0.02;     ///< of a handle that turns freely, about the grip [kg m^2]
  double rotationalDamping = 0.1;      ///< of the same [N m s/rad]
  double orientationStiffness = 20;    ///< of the spring that holds the handle in impedance display [N m/rad]
  double orientationDamping = 0.5;     ///< of the same [N m s/rad]
  double selfMotionDamping = 10;       ///< in impedance display, per inertia of the rotors [1/s]
};

/// When the safety circuit of the device stops the arm [paper, section III.D; docs/board.md], how far the host's clamps
/// let the session go, and when the host stops it. docs/safety.md tells each in words; `haptiv device check` holds the
/// clamps against the arm's specification.
struct SafetyThresholds {
  double watchdogTime = 0.01;  ///< longest time between two commands [s]
  /// A joint turns too fast when its encoder counts more than countThreshold within velocityTimeUnit [s].
  double velocityTimeUnit = 0.001;
  JointVector countThreshold = JointVector::Constant(512);
  double forceClamp = 170;         ///< largest force of the scene on the ball [N]
  double torqueClamp = 13;         ///< largest torque of the scene on the handle [N m]
  double speedClamp = 1.5;         ///< largest speed of the tool [m/s]
  double accelerationClamp = 100;  ///< by which the tool becomes faster, at most [m/s^2]
  double handForceLimit = 300;     ///< more than any hand can [N]; beyond: fault
  double oscillationSpeed = 0.1;   ///< amplitude of fast swings that do not die down [m/s]; beyond: fault
  double missedTime = 0.5;         ///< that the servo may miss within a second [s]; beyond: fault
};

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
  Pose tool;            ///< X_CT: the tool, in the frame of the wrist centre
  ArmBodies bodies;     ///< of the links; empty where they are not known
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
