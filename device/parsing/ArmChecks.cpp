#include "device/parsing/ArmChecks.h"

#include <cmath>
#include <initializer_list>
#include <limits>

#include "device/calibration/SensorMatrix.h"

namespace haptiv {
namespace {

/// So that the 32-bit counters hold at least 17 turns of a joint either way.
constexpr double kMostCountsPerRadian = 2e7;
constexpr double kLongestOffset = 100;  // [m]
constexpr double kFastestHand = 2000;   // [rad/s], a quarter of a turn a step of the simulation

class Checks {
 public:
  Checks(const TomlValues& toml, const toml::table& root, const DeviceDescription& description)
      : toml_(toml), root_(root), d_(description) {}

  void lengths() const;
  void sensor() const;
  void encoders() const;
  void counters() const;
  void safety() const;
  void hand() const;

 private:
  using Keys = std::initializer_list<std::string_view>;
  /// At the first of the keys that is in the file.
  [[noreturn]] void failAt(std::string_view section, Keys keys, const std::string& what) const {
    for (const auto key : keys) {
      if (const toml::node* node = root_[section][key].node()) toml_.fail(*node, what);
    }
    toml_.fail({1, 1}, what);
  }
  void range(std::string_view name, double range, double resolution) const;

  const TomlValues& toml_;
  const toml::table& root_;
  const DeviceDescription& d_;
};

void Checks::lengths() const {
  for (const auto& [section, key] :
       {std::pair{"links", "scara"}, {"links", "forearm"}, {"links", "lift"}, {"links", "scaraHeight"}}) {
    if (root_[section][key].value_or(0.0) > kLongestOffset)
      failAt(section, {key}, std::string(section) + "." + key + " is longer than 100 m; write metres");
  }
  for (const char* key : {"baseRadius", "baseOffset", "upperArm", "forearm", "hinges", "platformRadius"}) {
    if (std::abs(root_["delta"][key].value_or(0.0)) > kLongestOffset)
      failAt("delta", {key}, std::string("delta.") + key + " is longer than 100 m; write metres");
  }
  if (d_.tool.position.norm() > kLongestOffset) failAt("tool", {"xyz"}, "tool.xyz is longer than 100 m; write metres");
  if (d_.chain.end.position.norm() > kLongestOffset)
    failAt("chain", {"end"}, "chain.end is longer than 100 m; write metres");
  for (const ChainJoint& joint : d_.chain.joints) {
    if (joint.mount.position.norm() > kLongestOffset)
      failAt("chain", {"joint"}, "a chain.joint stands more than 100 m from the one before; write metres");
  }
}

void Checks::range(std::string_view name, double range, double resolution) const {
  const std::string rangeKey = std::string(name) + "Range", resolutionKey = std::string(name) + "Resolution";
  if (range > std::numeric_limits<std::int16_t>::max() * resolution)
    failAt("sensor", {rangeKey, resolutionKey},
           "sensor." + rangeKey + " is beyond 32767 counts of " + resolutionKey +
               "; lower the range or raise the resolution");
}

void Checks::sensor() const {
  range("force", d_.sensor.forceRange, d_.sensor.forceResolution);
  range("torque", d_.sensor.torqueRange, d_.sensor.torqueResolution);
  Vector6 most;
  most << Vector3::Constant(d_.sensor.forceRange), Vector3::Constant(d_.sensor.torqueRange);
  if ((d_.sensor.bias.cwiseAbs().array() > 0.5 * most.array()).any())
    failAt("sensor", {"bias"},
           "sensor.bias is beyond half of the sensor's range, which leaves too little of it; mend the sensor");
  if (!(sensorMatrixCondition(d_.sensor) <= kWorstSensorMatrix))
    failAt("sensor", {"matrix"},
           "sensor.matrix cannot be told back into what the sensor says: its condition is beyond 100; calibrate anew");
}

void Checks::encoders() const {
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  const JointVector countsPerRadian = d_.drives.countsPerRadian();
  for (int i = 0; i < d_.jointCount(); ++i) {
    const std::string joint = " of joint " + std::to_string(i + 1);
    if (d_.encoders.zero[i] != std::round(d_.encoders.zero[i]))
      failAt("encoders", {"zero"}, "encoders.zero" + joint + " is no whole number of counts; round it");
    for (const double angle : {0.0, d_.homeAngles[i], d_.encoders.reference[i]}) {
      if (std::abs(angle * countsPerRadian[i] + d_.encoders.zero[i]) > kMost)
        failAt("encoders", {"zero", "reference"},
               "encoders.zero or reference" + joint + " is beyond the 32-bit counters; take whole turns off it");
    }
  }
}

void Checks::counters() const {
  const JointVector countsPerRadian = d_.drives.countsPerRadian();
  if (countsPerRadian.maxCoeff() > kMostCountsPerRadian) {
    failAt("drives", {"gearRatio", "countsPerTurn"},
           "drives.gearRatio times countsPerTurn is beyond the 32-bit counters; lower one of them");
  }
  if (d_.homeAngles.cwiseProduct(countsPerRadian).cwiseAbs().maxCoeff() > std::numeric_limits<std::int32_t>::max())
    failAt("home", {"angles"}, "home.angles are beyond the 32-bit counters; take whole turns off them");
}

void Checks::safety() const {
  const JointVector shutOff =
      (d_.safety.countThreshold / d_.safety.velocityTimeUnit).cwiseQuotient(d_.drives.countsPerRadian());
  for (int i = 0; i < d_.jointCount(); ++i) {
    if (shutOff[i] < d_.drives.rateLimit[i])
      failAt("safety", {"countThreshold", "velocityTimeUnit"},
             "safety.countThreshold per velocityTimeUnit of joint " + std::to_string(i + 1) +
                 " is below its rateLimit, so the arm would stop in use; raise the threshold");
  }
}

void Checks::hand() const {
  const HandModel& hand = d_.hand;
  if (hand.gripStiffness <= hand.stiffness)
    failAt("hand", {"gripStiffness", "stiffness"},
           "hand.stiffness is that of arm and grip together, so gripStiffness is more than it; raise gripStiffness");
  const double fastest = std::sqrt(hand.gripStiffness / hand.mass);
  const double damping = (hand.gripDamping + hand.damping) / hand.mass;
  if (fastest > kFastestHand || damping > kFastestHand)
    failAt("hand", {"mass", "gripStiffness", "gripDamping"},
           "hand.mass is too small for its grip: it would swing faster than 2000 rad/s; raise it");
}

}  // namespace

void checkWhole(const TomlValues& toml, const toml::table& root, const DeviceDescription& description) {
  const Checks checks(toml, root, description);
  checks.lengths();
  checks.sensor();
  checks.counters();
  checks.encoders();
  checks.safety();
  checks.hand();
}

}  // namespace haptiv
