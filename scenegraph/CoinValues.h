#pragma once

#include "scenegraph/ToEigen.h"

namespace haptiv {

inline SbVec3f toCoin(const Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// Sets a field only where that changes it: setting an equal value would redraw all the same.
template <typename Field, typename Value>
void setIfChanged(Field& field, const Value& value) {
  if (field.getValue() != value) field.setValue(value);
}

}  // namespace haptiv
