#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

namespace haptiv {

/// Follows `image WIDTH HEIGHT BYTES` and `images WIDTH HEIGHT DEPTH BYTES` through the words of a text: Coin makes
/// room for the pixels before it looks for them.
class ImageSize {
 public:
  /// @param textSize  a pixel takes two characters at least, so that no image has more of them than the text
  explicit ImageSize(std::size_t textSize) : textSize_(static_cast<double>(textSize)) {}

  /// Whether the word is the last size of an image that cannot be in the text.
  bool isTooLarge(std::string_view word) {
    if (word == "image" || word == "images") {
      toCome_ = word == "image" ? 2 : 3;
      pixels_ = 1;
      return false;
    }
    if (toCome_ == 0) return false;
    pixels_ *= std::abs(std::strtod(std::string(word).c_str(), nullptr));
    return --toCome_ == 0 && pixels_ > textSize_;
  }

 private:
  double textSize_;
  int toCome_ = 0;  ///< sizes that come next
  double pixels_ = 0;
};

}  // namespace haptiv
