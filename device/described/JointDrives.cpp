#include "device/described/JointDrives.h"

#include <numbers>

namespace haptiv {

JointVector JointDrives::countsPerRadian() const {
  return gearRatio.cwiseProduct(countsPerTurn) / (2 * std::numbers::pi);
}

}  // namespace haptiv
