#pragma once

#include <string>

#include "scenegraph/isolation/Isolated.h"

namespace haptiv {

/// Has Coin read a scene, go through its shapes and write it, all in a process of its own. There is no fault where it
/// survives, and where it finds the scene wrong in a way that reading it here will tell.
Isolated rehearse(const std::string& text);

/// A binary scene as text, made by Coin in a process of its own.
Isolated convertBinary(const std::string& bytes);

}  // namespace haptiv
