#pragma once

#include "device/types.h"

namespace haptiv {

/// v / |v|, or `fallback` where v is zero.
inline Vector3 unitOr(const Vector3& v, const Vector3& fallback) noexcept {
  const double length = v.norm();
  return length > 0 ? Vector3(v / length) : fallback;
}

}  // namespace haptiv
