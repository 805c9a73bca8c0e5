#pragma once

#include <Inventor/SbRotation.h>
#include <Inventor/SbVec3f.h>

#include "device/types.h"

namespace haptiv {

inline SbVec3f toCoin(const Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline Vector3 toEigen(const SbVec3f& v) {
  return {v[0], v[1], v[2]};
}

/// Sets a field only where that changes it: setting an equal value would redraw all the same.
template <typename Field, typename Value>
void setIfChanged(Field& field, const Value& value) {
  if (field.getValue() != value) field.setValue(value);
}

}  // namespace haptiv
