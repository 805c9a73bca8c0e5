#include "device/usb/protocol/SetPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptiv::usb {

namespace {

/// Wire units per rad/s or N m.
double unitsOf(DriveMode mode, FrameForm form) noexcept {
  if (form == FrameForm::full) return 1e6;
  return mode == DriveMode::rate ? 1e5 : 1e4;
}

std::int64_t noNumber(FrameForm form) noexcept {
  return form == FrameForm::full ? -(std::int64_t{1} << 31) : -(std::int64_t{1} << 23);
}

}  // namespace

std::int64_t toWire(double value, DriveMode mode, FrameForm form) noexcept {
  if (!std::isfinite(value)) return noNumber(form);
  const auto most = static_cast<double>(-noNumber(form) - 1);
  return std::llround(std::clamp(value * unitsOf(mode, form), -most, most));
}

double fromWire(std::int64_t value, DriveMode mode, FrameForm form) noexcept {
  if (value == noNumber(form)) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(value) / unitsOf(mode, form);
}

}  // namespace haptiv::usb
