#include "device/parsing/ChainFormat.h"

#include "device/parsing/Section.h"

namespace haptiv {
namespace {

std::vector<ChainJoint> readJoints(const TomlValues& toml, const toml::node& node) {
  const toml::array* tables = node.as_array();
  if (tables == nullptr || tables->empty() || !tables->is_array_of_tables())
    toml.fail(node, "chain.joint is no list of joints; write [[chain.joint]] for each, its keys below");
  if (tables->size() > kJointCount)
    toml.fail((*tables)[kJointCount], "an arm has at most " + std::to_string(kJointCount) + " joints; remove the rest");
  std::vector<ChainJoint> joints(tables->size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    ChainJoint& joint = joints[i];
    readSection(toml, (*tables)[i],
                {"chain.joint " + std::to_string(i + 1),
                 {{"xyz", &joint.mount.position},
                  {"rpy", RollPitchYaw{&joint.mount.rotation}},
                  {"axis", Direction{&joint.axis}}}});
  }
  return joints;
}

}  // namespace

ChainGeometry readChain(const TomlValues& toml, const toml::node& node) {
  ChainGeometry chain;
  for (const auto& [key, value] : toml.table(node, "chain")) {
    if (key == "joint")
      chain.joints = readJoints(toml, value);
    else if (key == "end")
      readSection(toml, value,
                  {"chain.end", {{"xyz", &chain.end.position}, {"rpy", RollPitchYaw{&chain.end.rotation}}}});
    else
      toml.fail(key.source().begin, "unknown key chain." + shown(key) + "; remove it, or use one of joint, end");
  }
  if (chain.joints.empty()) toml.fail(node, "the chain has no joints; write [[chain.joint]] for each");
  return chain;
}

}  // namespace haptiv
