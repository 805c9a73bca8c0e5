#include "app/plots/samples/CalmRange.h"

#include <algorithm>
#include <cmath>

namespace haptiv {

namespace {

constexpr double kLargest = 1e12;     // beyond it labels make no sense, and spans could overflow
constexpr double kEmptyShare = 0.35;  // narrows where the values fill less than this
constexpr double kMargin = 0.06;      // of the span, on either side
constexpr int kSteps = 6;

/// The next of 1, 2, 5, 10, ... times a power of ten.
double roundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

}  // namespace

CalmRange::CalmRange(double minimumSpan) : minimumSpan_(minimumSpan) {
  reset();
}

void CalmRange::reset() {
  set_ = false;
  lower_ = 0;
  upper_ = minimumSpan_;
  step_ = roundStep(minimumSpan_ / kSteps);
}

void CalmRange::fit(double least, double greatest) {
  least = std::clamp(least, -kLargest, kLargest);
  greatest = std::clamp(greatest, least, kLargest);
  const double needed = std::max(greatest - least, minimumSpan_);
  const bool fits = least >= lower_ && greatest <= upper_;
  if (set_ && fits && needed >= kEmptyShare * (upper_ - lower_)) return;

  const double centre = (least + greatest) / 2;
  double lower = centre - needed * (0.5 + kMargin);
  double upper = centre + needed * (0.5 + kMargin);
  if (least >= 0 && least <= needed) {  // what is never negative stands on zero
    lower = 0;
    upper = std::max(greatest + kMargin * needed, minimumSpan_);
  }
  step_ = roundStep((upper - lower) / kSteps);
  lower_ = std::floor(lower / step_) * step_;
  upper_ = std::ceil(upper / step_) * step_;
  set_ = true;
}

}  // namespace haptiv
