#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <variant>
#include <vector>

#include "device/DeviceDescription.h"

namespace haptiv {

namespace {

constexpr std::int64_t kSchema = 1;

/// So that the 32-bit counters hold at least 17 turns of a joint either way.
constexpr double kMostCountsPerRadian = 2e7;

enum class Rule { any, notNegative, positive };

/// A key of the file: where its value goes, and what is possible for it.
struct Field {
  std::string_view key;
  std::variant<double*, JointVector*> target;
  Rule rule;
};

struct Section {
  std::string_view name;
  std::vector<Field> fields;
};

/// The whole format but for `schema` and `name`.
std::vector<Section> sectionsOf(DeviceDescription& d) {
  using enum Rule;
  return {
      {"links",
       {{"scara", &d.links.scara, positive},
        {"forearm", &d.links.forearm, notNegative},
        {"lift", &d.links.lift, positive},
        {"scaraHeight", &d.links.scaraHeight, notNegative},
        {"wristBracket", &d.links.wristBracket, notNegative}}},
      {"drives",
       {{"gearRatio", &d.drives.gearRatio, positive},
        {"countsPerTurn", &d.drives.countsPerTurn, positive},
        {"rateLimit", &d.drives.rateLimit, positive},
        {"torqueLimit", &d.drives.torqueLimit, positive},
        {"inertia", &d.drives.inertia, positive},
        {"bandwidth", &d.drives.bandwidth, positive}}},
      {"sensor",
       {{"forceResolution", &d.sensor.forceResolution, positive},
        {"torqueResolution", &d.sensor.torqueResolution, positive},
        {"forceNoise", &d.sensor.forceNoise, notNegative},
        {"torqueNoise", &d.sensor.torqueNoise, notNegative},
        {"forceRange", &d.sensor.forceRange, positive},
        {"torqueRange", &d.sensor.torqueRange, positive}}},
      {"hand",
       {{"stiffness", &d.hand.stiffness, notNegative},
        {"damping", &d.hand.damping, notNegative},
        {"peakForce", &d.hand.peakForce, positive},
        {"bandwidth", &d.hand.bandwidth, positive}}},
      {"control",
       {{"driftGain", &d.control.driftGain, notNegative},
        {"jointGain", &d.control.jointGain, notNegative},
        {"singularityDamping", &d.control.singularityDamping, positive},
        {"singularityThreshold", &d.control.singularityThreshold, positive},
        {"trackingErrorLimit", &d.control.trackingErrorLimit, positive}}},
      {"home", {{"angles", &d.homeAngles, any}}},
  };
}

class Parser {
 public:
  explicit Parser(const std::string& sourceName) : sourceName_(sourceName) {}

  void read(const toml::table& root, DeviceDescription& description) const;

 private:
  [[noreturn]] void fail(const toml::source_position& where, const std::string& what) const;
  void checkSchema(const toml::table& root) const;
  void readSection(const toml::node& node, const Section& section) const;
  double readNumber(const toml::node& node, const std::string& what, Rule rule) const;
  JointVector readJoints(const toml::node& node, const std::string& what, Rule rule) const;
  void checkWhole(const toml::table& root, const DeviceDescription& description) const;

  const std::string& sourceName_;
};

void Parser::fail(const toml::source_position& where, const std::string& what) const {
  std::ostringstream message;
  message << sourceName_ << ':' << where.line << ':' << where.column << ": " << what;
  throw std::runtime_error(message.str());
}

void Parser::checkSchema(const toml::table& root) const {
  const toml::node* node = root.get("schema");
  if (node == nullptr) fail({1, 1}, "the key schema is missing; write `schema = 1` at the top");
  if (node->value_exact<std::int64_t>() != kSchema) {
    fail(node->source().begin, "this schema is not known; write `schema = 1`");
  }
}

template <typename List>
std::string keysOf(const List& list, std::string_view List::value_type::*key) {
  std::string keys;
  for (const auto& entry : list) keys += (keys.empty() ? "" : ", ") + std::string(entry.*key);
  return keys;
}

void Parser::read(const toml::table& root, DeviceDescription& description) const {
  checkSchema(root);
  const auto sections = sectionsOf(description);
  for (const auto& [key, node] : root) {
    if (key == "schema") continue;
    if (key == "name") {
      description.name = node.value_exact<std::string>().value_or("");
      if (description.name.empty()) fail(node.source().begin, "name is no text; write a name in quotes");
      continue;
    }
    const auto section = std::find_if(sections.begin(), sections.end(), [&](const auto& s) { return s.name == key; });
    if (section == sections.end()) {
      fail(key.source().begin, "unknown key " + std::string(key) + "; remove it, or use one of schema, name, " +
                                   keysOf(sections, &Section::name));
    }
    readSection(node, *section);
  }
  checkWhole(root, description);
}

void Parser::readSection(const toml::node& node, const Section& section) const {
  const std::string name(section.name);
  if (!node.is_table()) fail(node.source().begin, name + " is no section; write [" + name + "] and its keys below");
  for (const auto& [key, value] : *node.as_table()) {
    const auto field = std::find_if(section.fields.begin(), section.fields.end(),
                                    [&](const auto& candidate) { return candidate.key == key; });
    const std::string what = name + "." + std::string(key);
    if (field == section.fields.end()) {
      fail(key.source().begin,
           "unknown key " + what + "; remove it, or use one of " + keysOf(section.fields, &Field::key));
    }
    if (const auto* number = std::get_if<double*>(&field->target)) **number = readNumber(value, what, field->rule);
    if (const auto* joints = std::get_if<JointVector*>(&field->target)) **joints = readJoints(value, what, field->rule);
  }
}

double Parser::readNumber(const toml::node& node, const std::string& what, Rule rule) const {
  const auto where = node.source().begin;
  if (!node.is_number()) fail(where, what + " is no number; write one, such as 0.5");
  const double value = *node.value<double>();
  if (!std::isfinite(value)) fail(where, what + " is not finite; write a finite number");
  if (rule == Rule::positive && value <= 0) fail(where, what + " must be greater than zero");
  if (rule == Rule::notNegative && value < 0) fail(where, what + " must not be negative");
  return value;
}

JointVector Parser::readJoints(const toml::node& node, const std::string& what, Rule rule) const {
  const toml::array* list = node.as_array();
  if (list == nullptr) fail(node.source().begin, what + " is no list; write [a, b, ...], one number a joint");
  if (list->size() != kJointCount) {
    fail(node.source().begin, what + " has " + std::to_string(list->size()) + " entries; give " +
                                  std::to_string(kJointCount) + ", one a joint");
  }
  JointVector values;
  for (int i = 0; i < kJointCount; ++i) {
    values[i] = readNumber((*list)[i], what + " of joint " + std::to_string(i + 1), rule);
  }
  return values;
}

/// What single values cannot tell: everything must fit the counters.
void Parser::checkWhole(const toml::table& root, const DeviceDescription& d) const {
  const auto failAt = [&](std::string_view section, std::array<std::string_view, 2> keys, const std::string& what) {
    for (const auto key : keys) {
      if (const toml::node* node = root[section][key].node()) fail(node->source().begin, what);
    }
    fail({1, 1}, what);
  };
  constexpr double kMostCounts = std::numeric_limits<std::int16_t>::max();
  if (d.sensor.forceRange > kMostCounts * d.sensor.forceResolution) {
    failAt("sensor", {"forceRange", "forceResolution"},
           "sensor.forceRange is beyond 32767 counts of forceResolution; lower the range or raise the resolution");
  }
  if (d.sensor.torqueRange > kMostCounts * d.sensor.torqueResolution) {
    failAt("sensor", {"torqueRange", "torqueResolution"},
           "sensor.torqueRange is beyond 32767 counts of torqueResolution; lower the range or raise the resolution");
  }
  const JointVector countsPerRadian = d.drives.countsPerRadian();
  if (countsPerRadian.maxCoeff() > kMostCountsPerRadian) {
    failAt("drives", {"gearRatio", "countsPerTurn"},
           "drives.gearRatio times countsPerTurn is too much for 32-bit counters; lower one of them");
  }
  if (d.homeAngles.cwiseProduct(countsPerRadian).cwiseAbs().maxCoeff() > std::numeric_limits<std::int32_t>::max()) {
    failAt("home", {"angles", "angles"}, "home.angles are beyond the 32-bit counters; take whole turns off them");
  }
}

}  // namespace

DeviceDescription parseDeviceDescription(std::string_view text, const std::string& sourceName) {
  const Parser parser(sourceName);
  DeviceDescription description;
  description.text = text;
  try {
    parser.read(toml::parse(text), description);
  } catch (const toml::parse_error& error) {
    std::ostringstream message;
    message << sourceName << ':' << error.source().begin.line << ':' << error.source().begin.column << ": "
            << error.description() << "; correct the TOML there";
    throw std::runtime_error(message.str());
  }
  return description;
}

}  // namespace haptiv
