#pragma once

#include <initializer_list>
#include <string>

namespace haptiv {

/// A number as it stands in a scene: to a hundredth of a millimetre, in as few characters as that takes, the same in
/// every language.
std::string sceneNumber(double value);
/// Several, with spaces between.
std::string sceneNumbers(std::initializer_list<double> values);

}  // namespace haptiv
