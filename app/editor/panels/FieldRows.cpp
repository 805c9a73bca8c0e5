#include "app/editor/panels/FieldRows.h"

namespace haptiv {
namespace {

using Kind = FieldRow::Kind;

FieldRow label() {
  return {Kind::text, "label", "Label", "The name that is shown here and in logs", {}, 1};
}

FieldRow enabled() {
  return {Kind::toggle, "enabled", "Felt", "Off: it is drawn, but the hand goes through it", {}, 1};
}

FieldRow stiffness(const QString& tip, double step) {
  return {Kind::number, "stiffness", "Stiffness", tip, {" N/m", 0, 1e6, step, 2}, 1};
}

FieldRow damping(const QString& tip) {
  return {Kind::number, "damping", "Damping", tip, {" N s/m", 0, 1e5, 1, 2}, 1};
}

FieldRow length(const char* field, const QString& title, const QString& tip, double minimum, double step) {
  return {Kind::number, field, title, tip, {" cm", minimum, 1e4, step, 3}, 100};
}

FieldRow point(const char* field, const QString& title, const QString& tip) {
  return {Kind::vector, field, title, tip, {" cm", -1e5, 1e5, 1, 2}, 100};
}

QVector<FieldRow> surfaceRows() {
  return {label(),
          enabled(),
          stiffness("How much force a centimetre of depth gives: F = k d", 100),
          damping("Brakes the hand only while it moves in"),
          length("hysteresis", "Hysteresis", "How much shallower the wall feels on the way out", 0,
                 0.01),
          {Kind::number,
           "staticFriction",
           "Static friction",
           "Of the normal force, before sliding",
           {"", 0, 10, 0.05, 3},
           1},
          {Kind::number,
           "dynamicFriction",
           "Sliding friction",
           "Of the normal force, while sliding",
           {"", 0, 10, 0.05, 3},
           1}};
}

QVector<FieldRow> springRows() {
  return {label(), enabled(), stiffness("Pull to the anchor for each metre of distance", 10),
          length("restLength", "Rest length", "The distance to the anchor at which nothing pulls", 0, 0.5),
          point("anchor", "Anchor", "Where the spring pulls to, from the middle of the shape, along the shape's axes")};
}

}  // namespace

QVector<FieldRow> rowsFor(const QString& keyword) {
  if (keyword == "HapticSurface") return surfaceRows();
  if (keyword == "HapticViscousZone") return {label(), enabled(), damping("Brakes the hand inside the zone")};
  if (keyword == "HapticSpringZone" || keyword == "HapticRubberBand") return springRows();
  if (keyword == "HapticTool") {
    return {{Kind::number, "mass", "Mass", "What the hand moves", {" kg", 0.01, 1000, 0.1, 3}, 1},
            damping("Brakes the ball everywhere"),
            length("radius", "Radius", "Of the ball", 0.01, 0.1),
            point("home", "Home", "Where a session starts")};
  }
  if (keyword == "HapticDevice") {
    return {{Kind::text, "description", "Device", "A built-in name such as vishard10, or a description file", {}, 1},
            point("position", "Position", "Where the device's base frame stands in the scene"),
            {Kind::yaw, "orientation", "Rotation", "Of the device about the upright axis", {" °", -360, 360, 5, 2}, 1},
            {Kind::number,
             "scale",
             "Scale",
             "Scene metres for each metre that the device moves",
             {"", 0.001, 1000, 0.1, 3},
             1}};
  }
  return {};
}

}  // namespace haptiv
