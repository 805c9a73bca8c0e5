#pragma once

#include "device/described/DeviceDescription.h"
#include "device/redundancy/criterion/CriterionPair.h"

namespace haptiv {

/// By what the criteria are divided before they are summed up, eq. (15): the average, over the description's
/// normalisation poses, of the best value that self-motion reaches from there, the tool standing still. The
/// translational and the rotational criterion are each driven to their best alone, along the gradient to the nearest
/// optimum. One where there is no such value.
///
/// For set-up: some hundred microseconds.
CriterionPair normalisation(const DeviceDescription& description, const ResolutionChoice& choice,
                            const JointVector& squaredWeights);

}  // namespace haptiv
