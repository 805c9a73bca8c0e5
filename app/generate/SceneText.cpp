#include "app/generate/SceneText.h"

#include <charconv>
#include <cmath>

namespace haptiv {

std::string sceneNumber(double value) {
  constexpr double kPerUnit = 1e5;
  const double rounded = std::round(value * kPerUnit) / kPerUnit;
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, rounded == 0 ? 0.0 : rounded).ptr;
  return {text, end};
}

std::string sceneNumbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + sceneNumber(value);
  return text;
}

}  // namespace haptiv
