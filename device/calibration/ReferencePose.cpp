#include "device/calibration/ReferencePose.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "device/calibration/QuietCheck.h"

namespace haptiv {

FoundZero findZero(const Samples& samples, const DeviceDescription& description, double mostChange) {
  expectWhole(samples);
  expectArmStands(samples, description);
  const JointVector perRadian = description.drives.countsPerRadian();
  const JointVector& reference = description.encoders.reference;
  FoundZero found;
  for (int i = 0; i < description.jointCount(); ++i) {
    const double counts = samples.encoderCounts()[static_cast<std::size_t>(i)];
    found.zero[i] = std::round(counts - reference[i] * perRadian[i]);
    found.change[i] = (description.encoders.zero[i] - found.zero[i]) / perRadian[i];
    if (std::abs(found.change[i]) <= mostChange) continue;
    std::ostringstream message;
    message.precision(3);
    message << "joint " << i + 1 << " stands at " << (counts - description.encoders.zero[i]) / perRadian[i]
            << " rad by the zero that the description has, and the reference pose is " << reference[i]
            << " rad; set the arm into the reference pose. Where no zero was known or power was lost, take any counts "
               "(--anew, or the box in the window)";
    throw CalibrationRefused(message.str());
  }
  return found;
}

}  // namespace haptiv
