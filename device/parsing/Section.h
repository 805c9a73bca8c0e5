#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "device/described/DeviceDescription.h"
#include "device/parsing/TomlValues.h"

namespace haptiv {

/// Where a value goes, and with it which values there can be.
struct JointList {
  JointVector* values;
  int joints;  ///< as many entries as the arm has joints
};
/// A row an axis of the sensor.
struct SquareOfAxes {
  Matrix6* rows;
};
struct PoseList {
  std::vector<JointVector>* poses;  ///< joint angles, a list a pose
  int joints;
};
/// A rotation as roll, pitch and yaw: turns about the fixed x, y and z axes, in this order.
struct RollPitchYaw {
  Matrix3* rotation;
};
/// A direction: any three numbers but zeros.
struct Direction {
  Vector3* unit;
};
/// A tensor of inertia: xx, yy, zz, xy, xz, yz.
struct Inertia {
  Matrix3* tensor;
};
using Target =
    std::variant<double*, bool*, std::string*, Strategy*, Solution*, DisplayMode*, JointController*, OrientationMode*,
                 StepLengths*, Vector3*, Vector6*, SquareOfAxes, RollPitchYaw, Direction, Inertia, JointList, PoseList>;

/// A key of the file.
struct Field {
  std::string_view key;
  Target target;
  Rule rule = Rule::any;
};

/// A table of the file.
struct Section {
  std::string name;
  std::vector<Field> fields;
};

/// Reads one table of the file. Throws as TomlValues does; unknown keys are refused.
void readSection(const TomlValues& toml, const toml::node& node, const Section& section);

}  // namespace haptiv
