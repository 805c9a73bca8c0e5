#include "app/experiments/CircularPath.h"

#include <cmath>
#include <numbers>

namespace haptiv {

Pose CircularPath::at(double t) const {
  const double phi = angle(t);
  return {centre + radius * Vector3(std::cos(phi), -std::sin(phi), 0), rotation};
}

double CircularPath::duration(double turns) const {
  return turns * 2 * std::numbers::pi * radius / speed;
}

}  // namespace haptiv
