#include "scenegraph/judging/ContactDynamics.h"

#include <cmath>
#include <limits>

namespace haptiv {

double ContactDynamics::naturalFrequency() const {
  return std::sqrt(stiffness / mass);
}

double ContactDynamics::dampingRatio() const {
  if (damping == 0) return 0;
  if (stiffness == 0) return std::numeric_limits<double>::infinity();
  return damping / (2 * mass * naturalFrequency());
}

double ContactDynamics::optimalStiffness() const {
  return damping * damping / (2 * mass);
}

double ContactDynamics::optimalDamping() const {
  return std::sqrt(2 * mass * stiffness);
}

double ContactDynamics::usedOfSampledBound(double period) const {
  return (stiffness * period * period + 2 * damping * period) / (4 * mass);
}

double ContactDynamics::largestSampledStiffness(double period) const {
  return 4 * mass / (period * period) - 2 * damping / period;
}

}  // namespace haptiv
