#include "app/session/log/contents/TickColumns.h"

#include <cstring>

namespace haptiv {
namespace {

using hdf5::Cell;

constexpr bool kInput = false;
constexpr bool kResult = true;

/// `field` gives the number's place in a record: TickRecord& -> T&, and the same of a const one. Number: the cell.
template <typename Number, typename Field>
TickColumn column(std::string name, std::string unit, bool result, Field field) {
  return {std::move(name),
          std::move(unit),
          result,
          [field](const TickRecord& record, std::byte* cell) {
            const auto number = static_cast<Number>(field(record));
            std::memcpy(cell, &number, sizeof number);
          },
          [field](TickRecord& record, const std::byte* cell) {
            Number number{};
            std::memcpy(&number, cell, sizeof number);
            auto& place = field(record);
            place = static_cast<std::decay_t<decltype(place)>>(number);
          },
          [field](const TickRecord& record) { return static_cast<double>(field(record)); }};
}

/// A column for each of `count` joints, counted from 1; `vector` gives the place of them all.
template <typename Number, typename Vector>
void addJoints(TickGroup& group, const std::string& name, const std::string& unit, bool result, Vector vector) {
  for (int i = 0; i < kJointCount; ++i) {
    const auto joint = static_cast<std::size_t>(i);
    const auto field = [ vector, joint ](auto& record) -> auto& {
      return vector(record)[joint];
    };
    group.columns.push_back(column<Number>(name + std::to_string(i + 1) + "_" + unit, unit, result, field));
  }
}

/// Columns x, y, z.
template <typename Vector>
void addVector(TickGroup& group, const std::string& name, const std::string& unit, Vector vector) {
  for (int i = 0; i < 3; ++i) {
    const auto field = [ vector, i ](auto& record) -> auto& {
      return vector(record)[i];
    };
    const std::string suffix = unit == "m/s" ? "m_per_s" : unit == "N m" ? "N_m" : unit;
    group.columns.push_back(column<double>(name + "_" + "xyz"[i] + "_" + suffix, unit, kResult, field));
  }
}

TickGroup timeGroup() {
  using Number = std::int64_t;
  TickGroup group{"time",
                  "",
                  Cell::int64,
                  {column<Number>(
                       "tick", "1", kInput, [](auto& r) -> auto& { return r.tick; }),
                   column<Number>(
                       "time_ns", "ns", kInput, [](auto& r) -> auto& { return r.time; }),
                   column<Number>(
                       "wake_lateness_ns", "ns", kInput, [](auto& r) -> auto& { return r.wakeLateness; }),
                   column<Number>(
                       "compute_time_ns", "ns", kInput, [](auto& r) -> auto& { return r.computeTime; }),
                   column<Number>(
                       "missed_ticks", "1", kInput, [](auto& r) -> auto& { return r.missedTicks; }),
                   column<Number>(
                       "device_time_us", "us", kInput, [](auto& r) -> auto& { return r.reading.deviceTime; })}};
  group.columns.back().since = 3;
  return group;
}

TickGroup rawGroup() {
  TickGroup group{"raw", "", Cell::int32, {}};
  addJoints<std::int32_t>(
      group, "encoder", "counts", kInput, [](auto& r) -> auto& { return r.reading.encoderCounts; });
  return group;
}

TickGroup sensorGroup() {
  TickGroup group{"sensor", "T", Cell::int16, {}};
  constexpr const char* kNames[] = {"force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z"};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto field = [i](auto& r) -> auto& {
      return r.reading.sensorCounts[i];
    };
    group.columns.push_back(
        column<std::int16_t>(std::string("sensor_") + kNames[i] + "_counts", "counts", kInput, field));
  }
  return group;
}

/// Joint rates are named by hand: "rad/s" is no part of a name.
TickGroup jointsGroup() {
  TickGroup group{"joints", "", Cell::float64, {}};
  addJoints<double>(
      group, "joint", "rad", kResult, [](auto& r) -> auto& { return r.jointAngles; });
  addJoints<double>(
      group, "desired_joint", "rad", kResult, [](auto& r) -> auto& { return r.desiredAngles; });
  for (int i = 0; i < kJointCount; ++i) {
    const auto field = [i](auto& r) -> auto& {
      return r.command.jointRates[i];
    };
    group.columns.push_back(
        column<double>("command_joint" + std::to_string(i + 1) + "_rad_per_s", "rad/s", kResult, field));
  }
  for (int i = 0; i < kJointCount; ++i) {
    const auto field = [i](auto& r) -> auto& {
      return r.command.jointTorques[i];
    };
    group.columns.push_back(column<double>("command_joint" + std::to_string(i + 1) + "_N_m", "N m", kResult, field));
  }
  return group;
}

TickGroup toolGroup() {
  TickGroup group{"tool", "W", Cell::float64, {}};
  addVector(
      group, "position", "m", [](auto& r) -> auto& { return r.position; });
  addVector(
      group, "desired_position", "m", [](auto& r) -> auto& { return r.desiredPosition; });
  addVector(
      group, "desired_velocity", "m/s", [](auto& r) -> auto& { return r.desiredVelocity; });
  addVector(
      group, "hand_force", "N", [](auto& r) -> auto& { return r.handForce; });
  addVector(
      group, "hand_torque", "N m", [](auto& r) -> auto& { return r.handTorque; });
  addVector(
      group, "environment_force", "N", [](auto& r) -> auto& { return r.environmentForce; });
  return group;
}

TickGroup contactGroup() {
  return {"contact",
          "",
          Cell::float64,
          {column<double>(
              "penetration_m", "m", kResult, [](auto& r) -> auto& { return r.penetration; })}};
}

TickGroup passivityGroup() {
  return {"passivity",
          "",
          Cell::float64,
          {column<double>(
               "energy_J", "J", kResult, [](auto& r) -> auto& { return r.passivityEnergy; }),
           column<double>(
               "added_damping_N_s_per_m", "N s/m", kResult, [](auto& r) -> auto& { return r.passivityDamping; })}};
}

TickGroup stateGroup() {
  using Number = std::int64_t;
  return {"state",
          "",
          Cell::int64,
          {column<Number>(
               "scene_version", "1", kInput, [](auto& r) -> auto& { return r.sceneVersion; }),
           column<Number>(
               "connected", "1", kInput, [](auto& r) -> auto& { return r.reading.connected; }),
           column<Number>(
               "inputs", "1", kInput, [](auto& r) -> auto& { return r.reading.inputs; }),
           column<Number>(
               "trips", "1", kInput, [](auto& r) -> auto& { return r.reading.trips; }),
           column<Number>(
               "contacts", "1", kResult, [](auto& r) -> auto& { return r.contacts; }),
           column<Number>(
               "zones", "1", kResult, [](auto& r) -> auto& { return r.zones; }),
           column<Number>(
               "deepest_wall", "1", kResult, [](auto& r) -> auto& { return r.deepestWall; }),
           column<Number>(
               "faults", "1", kResult, [](auto& r) -> auto& { return r.faults; }),
           column<Number>(
               "clamps", "1", kResult, [](auto& r) -> auto& { return r.clamps; }),
           column<Number>(
               "session_state", "1", kResult, [](auto& r) -> auto& { return r.state; }),
           column<Number>(
               "drive_mode", "1", kResult, [](auto& r) -> auto& { return r.command.mode; }),
           column<Number>(
               "enabled", "1", kResult, [](auto& r) -> auto& { return r.command.enabled; })}};
}

}  // namespace

std::vector<TickGroup> tickGroups() {
  return {timeGroup(), rawGroup(),     sensorGroup(),    jointsGroup(),
          toolGroup(), contactGroup(), passivityGroup(), stateGroup()};
}

}  // namespace haptiv
