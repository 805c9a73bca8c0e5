#include "device/parsing/BodiesFormat.h"

#include <Eigen/Eigenvalues>

#include "device/parsing/Section.h"

namespace haptiv {
namespace {

constexpr double kRounding = 1e-9;  // of the largest principal moment

/// Matter has principal moments that are not negative, none larger than the two others together.
bool isOfMatter(const Matrix3& inertia) {
  const Vector3 moments = Eigen::SelfAdjointEigenSolver<Matrix3>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  const double slack = kRounding * moments[2];
  return moments[0] >= -slack && moments[0] + moments[1] >= moments[2] - slack;
}

LinkBody readLink(const TomlValues& toml, const toml::node& node, std::size_t number) {
  LinkBody body;
  const std::string name = "bodies.link " + std::to_string(number);
  readSection(
      toml, node,
      {name, {{"mass", &body.mass, Rule::notNegative}, {"centre", &body.centre}, {"inertia", Inertia{&body.inertia}}}});
  if (!isOfMatter(body.inertia))
    toml.fail(node, name +
                        ".inertia is of no body: about its principal axes no moment is negative or more than the "
                        "two others together; give xx, yy, zz, xy, xz, yz about the centre of mass");
  return body;
}

}  // namespace

ArmBodies readBodies(const TomlValues& toml, const toml::node& node, int joints) {
  ArmBodies bodies;
  for (const auto& [key, value] : toml.table(node, "bodies")) {
    if (key == "gravity") {
      toml.numbers(value, "bodies.gravity", Rule::any, "coordinate", {bodies.gravity.data(), 3});
      continue;
    }
    if (key != "link")
      toml.fail(key.source().begin, "unknown key bodies." + shown(key) + "; remove it, or use one of link, gravity");
    const toml::array* links = value.as_array();
    if (links == nullptr || !links->is_array_of_tables() || links->size() != static_cast<std::size_t>(joints))
      toml.fail(value, "bodies.link is no list of " + std::to_string(joints) +
                           " bodies; write [[bodies.link]] for each joint, its keys below");
    for (const toml::node& link : *links) bodies.links.push_back(readLink(toml, link, bodies.links.size() + 1));
  }
  return bodies;
}

}  // namespace haptiv
