#pragma once

#include <cstddef>
#include <string_view>

namespace haptiv {

/// One token of Inventor text.
struct SceneToken {
  enum class Kind { end, word, string, open, close, openList, closeList, unclear, bad };
  Kind kind = Kind::end;
  std::string_view text;  ///< of a string: without its quotes; of `bad`: what is wrong
  int line = 1;           ///< where it begins, 1-based
};

/// Cuts Inventor text into tokens as Coin does. Where Coin's own reading depends on what it expects (an unquoted string
/// may hold quotes and comment signs), the token is `unclear`: what follows cannot be told from the text alone.
class SceneTokenizer {
 public:
  explicit SceneTokenizer(std::string_view text) : text_(text) {}

  /// After `end`, `unclear` and `bad` comes `end`.
  SceneToken next();

  /// What has not been cut yet.
  std::string_view rest() const { return text_.substr(at_); }

 private:
  void skipBlanks();
  void countLine();
  SceneToken readString();
  SceneToken readWord();
  SceneToken stop(SceneToken::Kind kind, std::string_view why);
  SceneToken bad(std::string_view why) { return stop(SceneToken::Kind::bad, why); }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace haptiv
