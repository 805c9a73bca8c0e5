#include "app/experiments/RunSetup.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "device/control/ResolutionNames.h"
#include "device/kinematics/Vishard10.h"

namespace haptiv {
namespace {

using std::numbers::pi;
constexpr double kSpeed = 1;             // where it is not varied [m/s]
constexpr double kShortest = 1;          // of a run [s]
constexpr double kPathRadius = 0.4;      // experiment 2 [m]
constexpr double kVelocityHeight = 0.3;  // [m]
constexpr double kTurns = 2;             // of experiment 2

/// Angles that put the wrist centre at (x, 0), with joint 3 on the positive y side, th5* = pi/2, th9 = -3 pi/4, th10 =
/// 0.
/// @param bend  th2 = th4: links 1 and 2, and 3 and 4, then reach as far as each other, and lie half of it beside
/// @param lift  th6, th7, th8; they give z and leave x and y alone: sin th6 + sin(th6+th7) = 0
JointVector startAngles(const LinkLengths& links, double x, double bend, const Vector3& lift) {
  const double pair = 2 * links.scara * std::cos(bend / 2);
  const double elbow = std::acos(x / (2 * pair));  // of a pair's direction above the line to the wrist centre
  JointVector q;
  q[0] = elbow - bend / 2;
  q[1] = bend;
  q[2] = -2 * elbow - bend;
  q[3] = bend;
  q[4] = pi / 2 - q.head<4>().sum();
  q.segment<3>(5) = lift;
  q[8] = -3 * pi / 4;
  q[9] = 0;
  return q;
}

RunSetup aboutWorkspaceCentre(const DeviceDescription& device, const ResolutionChoice& choice, double height,
                              double speed) {
  RunSetup run;
  run.choice = choice;
  const double th6 = std::acos(height / (2 * device.links.lift));  // eq. (23)
  run.startAngles = startAngles(device.links, 2 * kPathRadius, 0, {th6, -2 * th6, th6});
  run.path = {{kPathRadius, 0, height}, kPathRadius, speed, Vishard10(device.links).forward(run.startAngles).rotation};
  run.duration = run.path.duration(kTurns);
  return run;
}

}  // namespace

std::string nameOf(Experiment experiment) {
  return std::array{"circle", "heights", "velocities"}[static_cast<std::size_t>(experiment)];
}

std::string RunSetup::name() const {
  constexpr std::array kLetter = {'r', 'z', 'v'};
  std::array<char, 16> value{};
  std::snprintf(value.data(), value.size(), "%c%.2f", kLetter[static_cast<std::size_t>(experiment)], varied);
  return nameOf(experiment) + "-" + nameOf(choice.solution) + "-" + nameOf(choice.strategy) + "-" + value.data();
}

DeviceDescription deviceFor(Experiment experiment, const DeviceDescription& device) {
  DeviceDescription its = device;
  its.redundancy.normalisationPoses.clear();
  for (const double radius : kRadii)
    its.redundancy.normalisationPoses.push_back(circleRun(device, {}, radius).startAngles);
  if (experiment == Experiment::circle) return its;
  its.redundancy.stepFull = {2.1, 2.1, 2.1};
  its.redundancy.stepPartitioned = {0.53, 0.53, 0.53};
  its.redundancy.translationWeight = 1;
  its.redundancy.rotationWeight = 2;
  return its;
}

RunSetup circleRun(const DeviceDescription& device, const ResolutionChoice& choice, double radius) {
  RunSetup run;
  run.experiment = Experiment::circle;
  run.varied = radius;
  run.choice = choice;
  run.startAngles = startAngles(device.links, radius, -pi / 4, {5 * pi / 6, pi / 3, 5 * pi / 6});
  const Pose start = Vishard10(device.links).forward(run.startAngles);
  run.path = {{0, 0, start.position.z()}, radius, kSpeed, start.rotation};
  run.duration = std::max(kShortest, run.path.duration(1));
  return run;
}

RunSetup heightRun(const DeviceDescription& device, const ResolutionChoice& choice, double height) {
  RunSetup run = aboutWorkspaceCentre(device, choice, height, kSpeed);
  run.experiment = Experiment::heights;
  run.varied = height;
  return run;
}

RunSetup velocityRun(const DeviceDescription& device, const ResolutionChoice& choice, double speed) {
  RunSetup run = aboutWorkspaceCentre(device, choice, kVelocityHeight, speed);
  run.experiment = Experiment::velocities;
  run.varied = speed;
  return run;
}

std::vector<RunSetup> runsOf(Experiment experiment, const DeviceDescription& device,
                             const std::vector<ResolutionChoice>& choices) {
  std::vector<RunSetup> runs;
  for (const ResolutionChoice& choice : choices) {
    switch (experiment) {
      case Experiment::circle:
        for (const double radius : kRadii) runs.push_back(circleRun(device, choice, radius));
        break;
      case Experiment::heights:
        for (const double height : kHeights) runs.push_back(heightRun(device, choice, height));
        break;
      case Experiment::velocities:
        for (const double speed : kSpeeds) runs.push_back(velocityRun(device, choice, speed));
        break;
    }
  }
  return runs;
}

}  // namespace haptiv
