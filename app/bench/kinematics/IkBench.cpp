#include <memory>
#include <numbers>
#include <random>

#include "app/bench/Benches.h"
#include "app/bench/kinematics/KdlArm.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/RedundancyResolution.h"

namespace haptiv {
namespace {

constexpr int kIkPasses = 15;
constexpr int kPoses = 1000;
constexpr double kIkPeriod = 1e-3;

struct Task {
  JointVector q;
  Vector6 twist;
};

/// Any pose, singular ones among them; any twist of up to 1 m/s and 1 rad/s an axis.
std::vector<Task> tasks() {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> part(-1, 1);
  std::vector<Task> all(kPoses);
  for (Task& task : all) {
    for (double& angle : task.q) angle = std::numbers::pi * part(engine);
    for (double& component : task.twist) component = part(engine);
  }
  return all;
}

/// All ways through the same tasks, in turn with the peer.
struct Timed {
  explicit Timed(std::string itsName) : name(std::move(itsName)), times(kPoses) {}
  std::string name;
  CallTimes times;
};

void addResults(BenchRun& run, const std::vector<Timed>& all, const std::string& peer, const CallTimes* peerTimes) {
  for (const Timed& timed : all) {
    BenchResult result = resultOf(timed.name, kJointCount, timed.times);
    if (peerTimes != nullptr) {
      result.peer = peer;
      result.peerMedianNs = peerTimes->median();
    }
    run.add(result);
  }
}

}  // namespace

void benchIk(BenchRun& run) {
  run.tell("ik: " + std::to_string(kPoses) + " poses");
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ArmKinematics arm(description);
  const RedundancyResolution resolution(description);
  const auto kdl = KdlArm::isBuiltIn() ? std::make_unique<KdlArm>(description.links) : nullptr;

  Timed forward("ik/fk_jacobian"), kdlInverse("ik/kdl_pinv");
  CallTimes kdlForward(kPoses);
  std::vector<ResolutionChoice> choices;
  std::vector<Timed> ways;
  for (const Solution solution : kSolutions) {
    for (const Strategy strategy : kStrategies) {
      choices.push_back({strategy, solution});
      ways.emplace_back("ik/" + nameOf(solution) + "/" + nameOf(strategy));
    }
  }
  const std::vector<Task> all = tasks();
  for (int pass = 0; pass < kIkPasses; ++pass) {
    for (const Task& task : all) {
      forward.times.time([&] { return arm.evaluate(task.q); });
      for (std::size_t i = 0; i < ways.size(); ++i) {
        ways[i].times.time(
            [&] { return resolution.rates(choices[i], task.q, arm.jacobian(task.q), task.twist, kIkPeriod); });
      }
      if (!kdl) continue;
      kdlForward.time([&] { return kdl->forwardAndJacobian(task.q); });
      kdlInverse.times.time([&] { return kdl->rates(task.q, task.twist); });
    }
    for (CallTimes* times : {&forward.times, &kdlForward, &kdlInverse.times}) times->endPass();
    for (Timed& way : ways) way.times.endPass();
  }
  addResults(run, {forward}, "KDL's FK and Jacobian", kdl ? &kdlForward : nullptr);
  addResults(run, ways, "KDL's ChainIkSolverVel_pinv", kdl ? &kdlInverse.times : nullptr);
  if (kdl) addResults(run, {kdlInverse}, "", nullptr);
}

}  // namespace haptiv
