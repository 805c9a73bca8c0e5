#pragma once

#include <cstdio>
#include <string>

namespace haptiv {

/// A number as a person writes it: "-5", "0.25", "nan".
inline std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

}  // namespace haptiv
