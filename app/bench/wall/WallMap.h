#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/bench/wall/WallTrial.h"

namespace haptiv {

/// Up to which stiffness a variant of the wall is stable under a grip.
struct WallLimit {
  WallVariant variant;
  std::string grip;
  std::vector<double> stiffness;  ///< a damping each [N/m]: every one below was stable; 0: none; infinite: all
};

/// How much the law's wall still shakes under a grip.
struct WallShaking {
  std::string grip;
  std::vector<double> oscillation;  ///< [N], row by row of stiffness; infinite: fault, or contact lost
  std::vector<char> stable;         ///< the same places
};

/// The Z-width of a device at a rate: which walls can be shown without shaking.
struct WallMap {
  std::string device;
  ControlChoice control;          ///< but for passivity control, which is a variant
  double rate = 0;                ///< [Hz]
  double mass = 0;                ///< of the virtual mass [kg]
  std::vector<double> damping;    ///< ascending, by equal factors [N s/m]
  std::vector<double> stiffness;  ///< the rows, ascending, by equal factors [N/m]
  std::vector<WallLimit> limits;
  std::vector<WallShaking> shaking;
  std::uint64_t trials = 0;
  std::vector<double> tickNs;  ///< mean time of a tick of the chain, simulated arm included, trial by trial [ns]

  /// k = b^2 / 2m  [paper, eq. (33)]: a damping ratio of 0.707.
  double optimalStiffness(double b) const { return b * b / (2 * mass); }
};

/// From how fine a net the limits are found.
struct WallNet {
  std::vector<double> damping = geometric(1, 1000, 10);
  std::vector<double> stiffness = geometric(1e3, 1e7, 13);
  int refinements = 2;  ///< halvings of the factor between two rows

  static std::vector<double> geometric(double first, double last, int count);
};

/// Maps a device by simulation on all processors: the law at every place of the net, the variants by bisection; then
/// all limits are refined. The same device gives the same map.
/// @param tell  called now and then with what is done, from this thread
WallMap mapWalls(const DeviceDescription& description, double rate, const WallNet& net,
                 const std::function<void(const std::string&)>& tell);

}  // namespace haptiv
