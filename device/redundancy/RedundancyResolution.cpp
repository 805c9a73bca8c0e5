#include "device/redundancy/RedundancyResolution.h"

#include "device/redundancy/LeastNorm.h"

namespace haptiv {

RedundancyResolution::RedundancyResolution(const DeviceDescription& description)
    : settings_(description.redundancy), control_(description.control) {}

JointVector RedundancyResolution::rates(const ResolutionChoice&, const JointVector&, const Jacobian& J,
                                        const Vector6& twist, double) const noexcept {
  const JointVector rates = leastNormRates(J, twist, control_);
  return rates.allFinite() ? rates : JointVector::Zero();
}

}  // namespace haptiv
