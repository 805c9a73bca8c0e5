#include "scenegraph/reading/text/SceneTokenizer.h"

namespace haptiv {
namespace {

using Kind = SceneToken::Kind;

constexpr std::size_t kMaxWord = 1000;                    // Coin crashes on identifiers of 100k characters
constexpr std::size_t kMaxString = std::size_t{1} << 16;  // Coin's writing of strings is quadratic in their length

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f' || c == ',';
}
bool endsWord(char c) {
  return isBlank(c) || c == '\0' || c == '{' || c == '}' || c == '[' || c == ']' || c == '"' || c == '#';
}

}  // namespace

SceneToken SceneTokenizer::next() {
  skipBlanks();
  if (at_ >= text_.size()) return {Kind::end, {}, line_};
  const char c = text_[at_];
  const auto single = [&](Kind kind) { return SceneToken{kind, text_.substr(at_++, 1), line_}; };
  switch (c) {
    case '{':
      return single(Kind::open);
    case '}':
      return single(Kind::close);
    case '[':
      return single(Kind::openList);
    case ']':
      return single(Kind::closeList);
    case '"':
      return readString();
    case '\0':
      return single(Kind::word);  // nothing that Coin reads
    default:
      return readWord();
  }
}

// A line ends with \n, \r\n or, as old files do, \r alone.
void SceneTokenizer::countLine() {
  const char c = text_[at_];
  const bool pair = c == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
  if (c == '\n' || (c == '\r' && !pair)) ++line_;
}

void SceneTokenizer::skipBlanks() {
  bool comment = false;
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n' || c == '\r') comment = false;
    if (c == '#') comment = true;
    if (!comment && !isBlank(c)) return;
    countLine();
  }
}

// A quote with a backslash before it does not end the string, whatever stands before the backslash: so Coin reads.
SceneToken SceneTokenizer::readString() {
  const int line = line_;
  const std::size_t first = ++at_;
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '"' && (at_ == first || text_[at_ - 1] != '\\')) {
      return {Kind::string, text_.substr(first, at_++ - first), line};
    }
    if (at_ - first >= kMaxString) return bad("the string is longer than 65536 characters: shorten it");
    countLine();
  }
  line_ = line;
  return bad("the string that begins here never ends: close it with a quotation mark");
}

SceneToken SceneTokenizer::readWord() {
  const std::size_t first = at_;
  while (at_ < text_.size() && !endsWord(text_[at_])) ++at_;
  const std::string_view word = text_.substr(first, at_ - first);
  if (word.size() > kMaxWord) return bad("a word is longer than 1000 characters: shorten it");
  if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '#')) {
    return stop(Kind::unclear, "a quotation mark or # stands right after a word");
  }
  return {Kind::word, word, line_};
}

SceneToken SceneTokenizer::stop(Kind kind, std::string_view why) {
  at_ = text_.size();
  return {kind, why, line_};
}

}  // namespace haptiv
