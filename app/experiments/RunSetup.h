#pragma once

#include <string>
#include <vector>

#include "app/experiments/CircularPath.h"
#include "device/control/ResolutionChoice.h"
#include "device/described/DeviceDescription.h"
#include "device/types.h"

namespace haptiv {

/// The paper's numerical experiments, section VI.
enum class Experiment {
  circle,      ///< about joint axis 1, at radii from 0.05 to 0.8 m
  heights,     ///< about (0.4, 0), at heights from -0.3 to 0 m
  velocities,  ///< about (0.4, 0) at z = 0.3 m, at 0.1 and 1 m/s
};

inline constexpr double kRadii[] = {0.05, 0.2, 0.4, 0.6, 0.8};  // [m]
inline constexpr double kHeights[] = {-0.3, -0.15, 0};          // [m]
inline constexpr double kSpeeds[] = {0.1, 1};                   // [m/s]

/// One run: where the arm starts, the path, and how its redundancy is resolved.
struct RunSetup {
  Experiment experiment = Experiment::circle;
  double varied = 0;  ///< what the experiment varies: radius [m], height [m] or speed [m/s]
  ResolutionChoice choice;
  JointVector startAngles = JointVector::Zero();  ///< [rad]
  CircularPath path;
  double duration = 0;  ///< [s]

  /// Such as circle-full-nonopt-r0.40.
  std::string name() const;
};

/// As on the command line.
std::string nameOf(Experiment experiment);

/// The arm's description with step lengths and weights as the experiment asks: those of experiment 2 are the paper's,
/// those of experiment 1 stay the description's. Criteria are normalised at the five start poses of experiment 1.
DeviceDescription deviceFor(Experiment experiment, const DeviceDescription& device);

/// A run of the circle at radius r [m]: one turn at 1 m/s, or 1 s where the turn is shorter.
RunSetup circleRun(const DeviceDescription& device, const ResolutionChoice& choice, double radius);
/// Two turns about (0.4, 0, z) from (0.8, 0, z) at 1 m/s.
RunSetup heightRun(const DeviceDescription& device, const ResolutionChoice& choice, double height);
/// Two turns about (0.4, 0, 0.3) from (0.8, 0, 0.3) at this speed [m/s].
RunSetup velocityRun(const DeviceDescription& device, const ResolutionChoice& choice, double speed);

/// All runs of an experiment with these choices.
std::vector<RunSetup> runsOf(Experiment experiment, const DeviceDescription& device,
                             const std::vector<ResolutionChoice>& choices);

}  // namespace haptiv
