#pragma once

#include <functional>
#include <string>

namespace haptiv {

/// A picture as Coin takes it.
struct Picture {
  short width = 0;
  short height = 0;
  int components = 0;  ///< bytes of a pixel: 1 grey, 2 grey and opacity, 3 red, green and blue, 4 these and opacity
  std::string pixels;  ///< row by row from below
};

/// Makes a picture of a file's contents. Throws std::runtime_error that says why it cannot. It is called in a process of
/// its own, in which it may crash, and which opens no file.
using DecodePicture = std::function<Picture(const std::string& contents)>;

}  // namespace haptiv
