#pragma once

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// p_WX of a place p_BX [m]. Realtime-safe: yes.
inline Vector3 placeInScene(const DevicePlacement& device, const Vector3& p_BX) noexcept {
  return device.position + device.scale * (device.rotation * p_BX);
}

/// p_BX of a place p_WX [m]. Realtime-safe: yes.
inline Vector3 placeInBase(const DevicePlacement& device, const Vector3& p_WX) noexcept {
  return device.rotation.transpose() * (p_WX - device.position) / device.scale;
}

}  // namespace haptiv
