#pragma once

#include <string>

namespace haptiv {

/// Has Coin read a scene, go through its shapes and write it, all in a process of its own. Empty where it survives, and
/// where it finds the scene faulty in a way that reading it here will tell; otherwise what happened and where.
std::string rehearsalFault(const std::string& text);

/// A binary scene as text, made by Coin in a process of its own.
struct Converted {
  std::string text;
  std::string fault;
};
Converted convertBinary(const std::string& bytes);

}  // namespace haptiv
