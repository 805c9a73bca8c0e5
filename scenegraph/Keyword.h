#pragma once

#include <Inventor/SoType.h>

#include <string>

class SoNode;

namespace haptiv {

/// The type that a keyword stands for in a file; bad where there is none.
SoType typeOfKeyword(const std::string& keyword, bool vrml2);

/// How diagnostics call a node: its keyword and, where it has one, its label or DEF name: HapticSurface "outer frame".
std::string describe(const SoNode* node);

}  // namespace haptiv
