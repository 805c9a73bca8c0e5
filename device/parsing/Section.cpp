#include "device/parsing/Section.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "device/control/ControlNames.h"
#include "device/control/ResolutionNames.h"

namespace haptiv {
namespace {

using enum Rule;

constexpr std::size_t kMostPoses = 100;

template <typename Choices>
std::vector<std::string> namesOf(const Choices& choices) {
  std::vector<std::string> names;
  for (const auto choice : choices) names.push_back(nameOf(choice));
  return names;
}

/// Puts one value where its field says.
struct Reader {
  const TomlValues& toml;
  const toml::node& node;
  const std::string& what;
  Rule rule;

  void operator()(double* value) const { *value = toml.number(node, what, rule); }
  void operator()(bool* value) const { *value = toml.truth(node, what); }
  void operator()(std::string* value) const { *value = toml.text(node, what); }
  void operator()(Strategy* value) const { *value = kStrategies[toml.choice(node, what, namesOf(kStrategies))]; }
  void operator()(DisplayMode* value) const { *value = kDisplayModes[toml.choice(node, what, namesOf(kDisplayModes))]; }
  void operator()(JointController* value) const {
    *value = kJointControllers[toml.choice(node, what, namesOf(kJointControllers))];
  }
  void operator()(OrientationMode* value) const {
    *value = kOrientationModes[toml.choice(node, what, namesOf(kOrientationModes))];
  }
  void operator()(Solution* value) const { *value = kSolutions[toml.choice(node, what, namesOf(kSolutions))]; }
  void operator()(StepLengths* steps) const {
    readSection(
        toml, node,
        {what,
         {{"man", &steps->man, notNegative}, {"dir", &steps->dir, notNegative}, {"cond", &steps->cond, notNegative}}});
  }
  void operator()(Vector3* value) const { toml.numbers(node, what, rule, "coordinate", {value->data(), 3}); }
  void operator()(Vector6* value) const { toml.numbers(node, what, rule, "axis", {value->data(), 6}); }
  void operator()(const SquareOfAxes& target) const {
    const toml::array& rows = toml.list(node, what, "six lists of six numbers, one an axis");
    if (rows.size() != 6) toml.fail(node, what + " has " + std::to_string(rows.size()) + " rows; give 6, one an axis");
    for (int i = 0; i < 6; ++i) {
      Vector6 row;
      toml.numbers(rows[static_cast<std::size_t>(i)], what + ", row " + std::to_string(i + 1), any, "axis",
                   {row.data(), 6});
      target.rows->row(i) = row;
    }
  }
  void operator()(const RollPitchYaw& target) const {
    Vector3 angles;
    toml.numbers(node, what, any, "angle", {angles.data(), 3});
    const auto about = [](double angle, const Vector3& axis) { return Eigen::AngleAxisd(angle, axis); };
    *target.rotation = (about(angles.z(), Vector3::UnitZ()) * about(angles.y(), Vector3::UnitY()) *
                        about(angles.x(), Vector3::UnitX()))
                           .toRotationMatrix();
  }
  void operator()(const Direction& target) const {
    Vector3 direction;
    toml.numbers(node, what, any, "coordinate", {direction.data(), 3});
    const double length = direction.stableNorm();
    if (length == 0) toml.fail(node, what + " has no direction; write one, such as [0, 0, 1]");
    *target.unit = (direction / length).normalized();
  }
  void operator()(const Inertia& target) const {
    Vector6 v;
    toml.numbers(node, what, any, "entry", {v.data(), 6});
    *target.tensor << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  }
  void operator()(const JointList& list) const {
    toml.numbers(node, what, rule, "joint", {list.values->data(), static_cast<std::size_t>(list.joints)});
  }
  void operator()(const PoseList& list) const {
    const toml::array& poses = toml.list(node, what, "the joint angles of one pose each");
    if (poses.size() > kMostPoses) toml.fail(node, what + " has more than 100 poses; give fewer");
    list.poses->assign(poses.size(), JointVector::Zero());
    for (std::size_t i = 0; i < poses.size(); ++i)
      toml.numbers(poses[i], what + ", pose " + std::to_string(i + 1), any, "joint",
                   {(*list.poses)[i].data(), static_cast<std::size_t>(list.joints)});
  }
};

}  // namespace

void readSection(const TomlValues& toml, const toml::node& node, const Section& section) {
  for (const auto& [key, value] : toml.table(node, section.name)) {
    const auto field = std::find_if(section.fields.begin(), section.fields.end(),
                                    [&](const auto& candidate) { return candidate.key == key.str(); });
    if (field == section.fields.end()) {
      std::string known;
      for (const Field& one : section.fields) known += (known.empty() ? "" : ", ") + std::string(one.key);
      toml.fail(key.source().begin,
                "unknown key " + section.name + "." + shown(key) + "; remove it, or use one of " + known);
    }
    const std::string what = section.name + "." + std::string(field->key);
    std::visit(Reader{toml, value, what, field->rule}, field->target);
  }
}

}  // namespace haptiv
