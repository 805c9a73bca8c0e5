#pragma once

#include <string>

class SoNode;

namespace haptiv {

/// A graph as text, whatever its values are.
/// @param digits  of floating-point numbers: 8 are easy to read, 9 give back every bit
std::string graphText(SoNode* root, int digits = 8, const char* header = "#Inventor V2.1 ascii");

}  // namespace haptiv
