#pragma once

#include <cstdint>
#include <string>

namespace haptiv {

/// An island as a mesh: hills out of the sea, columns x rows quadrilaterals of two triangles each. The sea is a viscous
/// zone. Inventor text, with comments; the same numbers give the same text on every machine that computes as IEEE 754
/// says, but for the last digit of the exponential function.
std::string reliefScene(int columns, int rows, std::uint64_t seed);

}  // namespace haptiv
