#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "device/described/DeviceDescription.h"
#include "device/parsing/ArmChecks.h"
#include "device/parsing/BodiesFormat.h"
#include "device/parsing/ChainFormat.h"
#include "device/parsing/DescriptionFormat.h"
#include "device/parsing/NestingGuard.h"

namespace haptiv {
namespace {

constexpr std::int64_t kSchema = 1;
constexpr double kShutOffRate = 1.25;  // of the rate limit, where a description names no count threshold

void checkSchema(const TomlValues& toml, const toml::table& root) {
  const toml::node* node = root.get("schema");
  if (node == nullptr) toml.fail({1, 1}, "the key schema is missing; write `schema = 1` at the top");
  if (node->value_exact<std::int64_t>() != kSchema) toml.fail(*node, "this schema is not known; write `schema = 1`");
}

void readType(const TomlValues& toml, const toml::table& root, DeviceDescription& d) {
  const toml::node* type = root.get("type");
  if (type == nullptr || toml.choice(*type, "type", {"admittance", "impedance"}) == 0) return;
  d.type = DeviceType::impedance;
  // Where [control] and [sensor] do not say otherwise: counts that are always zero have no noise.
  d.control.choice.display = DisplayMode::impedance;
  d.sensor.forceNoise = d.sensor.torqueNoise = 0;
}

void readArm(const TomlValues& toml, const toml::table& root, DeviceDescription& d) {
  if (root.get("delta") != nullptr) {
    d.delta.emplace();
    for (const char* other : {"links", "chain", "bodies"}) {
      if (const toml::node* node = root.get(other))
        toml.fail(*node,
                  "[" + std::string(other) + "] is of a serial arm and [delta] a parallel one; remove one of them");
    }
  }
  const toml::node* chain = root.get("chain");
  if (chain == nullptr) return;
  if (const toml::node* links = root.get("links"))
    toml.fail(*links, "[links] are VISHARD10's and [chain] is another arm; remove one of them");
  d.chain = readChain(toml, *chain);
}

void read(const TomlValues& toml, const toml::table& root, DeviceDescription& d) {
  checkSchema(toml, root);
  readType(toml, root, d);
  readArm(toml, root, d);
  if (const toml::node* bodies = root.get("bodies")) d.bodies = readBodies(toml, *bodies, d.jointCount());
  const auto sections = sectionsOf(d, d.jointCount());
  for (const auto& [key, node] : root) {
    if (key == "schema" || key == "type" || key == "chain" || key == "bodies") continue;
    if (key == "name") {
      d.name = toml.text(node, "name");
      continue;
    }
    const auto section =
        std::find_if(sections.begin(), sections.end(), [&](const auto& one) { return one.name == key.str(); });
    if (section == sections.end()) {
      std::string known;
      for (const Section& one : sections) known += ", " + one.name;
      toml.fail(key.source().begin,
                "unknown key " + shown(key) + "; remove it, or use one of schema, name, type, chain, bodies" + known);
    }
    readSection(toml, node, *section);
  }
  if (!root["safety"]["countThreshold"])
    d.safety.countThreshold =
        kShutOffRate * d.safety.velocityTimeUnit * d.drives.rateLimit.cwiseProduct(d.drives.countsPerRadian());
  if (!root["encoders"]["reference"]) d.encoders.reference = d.homeAngles;
  checkWhole(toml, root, d);
}

}  // namespace

DeviceDescription parseDeviceDescription(std::string_view text, const std::string& sourceName) {
  const TomlValues toml(sourceName);
  if (const auto line = lineOfEndlessKey(text))
    toml.fail({*line, 1}, "a key of more than 64 parts; no description has one");
  DeviceDescription description;
  description.text = text;
  try {
    read(toml, toml::parse(text), description);
  } catch (const toml::parse_error& error) {
    toml.fail(error.source().begin, std::string(error.description()) + "; correct the TOML there");
  }
  return description;
}

}  // namespace haptiv
