#include "tests/fuzz/Mutation.h"

#include <array>
#include <cctype>
#include <utility>

namespace haptiv::testing {
namespace {

constexpr std::size_t kMaxSize = 1 << 16;

/// A stretch of text: where it begins and how long it is.
using Part = std::pair<std::size_t, std::size_t>;

template <typename Is>
std::vector<Part> partsThatAre(const std::string& text, const Is& is) {
  std::vector<Part> parts;
  for (std::size_t i = text.find('\n'); i < text.size(); ++i) {  // the header stays
    const std::size_t first = i;
    while (i < text.size() && is(static_cast<unsigned char>(text[i]))) ++i;
    if (i > first) parts.emplace_back(first, i - first);
  }
  return parts;
}

std::vector<Part> wordsOf(const std::string& text) {
  return partsThatAre(text, [](unsigned char c) { return std::isalpha(c); });
}

std::vector<Part> numbersOf(const std::string& text) {
  return partsThatAre(text, [](unsigned char c) { return std::isdigit(c) || c == '.' || c == '-'; });
}

/// From a bracket to the one that closes it, with the word before; nothing where there is none.
Part blockAt(const std::string& text, std::size_t from) {
  const std::size_t open = text.find('{', from);
  if (open == std::string::npos) return {0, 0};
  std::size_t end = open;
  for (int depth = 0; end < text.size(); ++end) {
    if (text[end] == '{') ++depth;
    if (text[end] == '}' && --depth == 0) break;
  }
  std::size_t first = open;
  while (first > 0 && text[first - 1] == ' ') --first;
  while (first > 0 && std::isalnum(static_cast<unsigned char>(text[first - 1]))) --first;
  return {first, end + 1 - first};
}

}  // namespace

Mutation::Mutation(std::vector<std::string> corpus, std::vector<std::string> words, unsigned seed)
    : corpus_(std::move(corpus)), words_(std::move(words)), random_(seed) {}

std::string Mutation::next() {
  std::string text = corpus_[below(corpus_.size())];
  for (std::size_t count = 1 + below(6); count > 0; --count) mutate(text);
  if (text.size() > kMaxSize) text.resize(kMaxSize);
  return text;
}

void Mutation::mutate(std::string& text) {
  if (text.empty()) return;
  static constexpr std::array kWays = {&Mutation::replaceWord,     &Mutation::replaceNumber, &Mutation::replaceNumber,
                                       &Mutation::changeByte,      &Mutation::deletePart,    &Mutation::repeatPart,
                                       &Mutation::insertFromOther, &Mutation::insertNode,    &Mutation::insertNode};
  (this->*kWays[below(kWays.size())])(text);
}

void Mutation::replaceWord(std::string& text) {
  const auto words = wordsOf(text);
  if (words.empty()) return;
  const auto [at, size] = words[below(words.size())];
  text.replace(at, size, words_[below(words_.size())]);
}

void Mutation::replaceNumber(std::string& text) {
  static const std::vector<std::string> kNumbers = {"0",      "-1",  "1",       "2",    "-2",         "7",       "255",
                                                    "1000",   "1e9", "-1e9",    "1e38", "1e-38",      "0.5",     "nan",
                                                    "100000", "-0",  "1 2 3 4", "",     "2147483647", "[ 1, 2 ]"};
  const auto numbers = numbersOf(text);
  if (numbers.empty()) return;
  const auto [at, size] = numbers[below(numbers.size())];
  text.replace(at, size, kNumbers[below(kNumbers.size())]);
}

void Mutation::changeByte(std::string& text) {
  text[below(text.size())] = static_cast<char>(below(2) == 0 ? below(256) : 32 + below(95));
}

void Mutation::deletePart(std::string& text) {
  const auto [at, size] = below(2) == 0 ? blockAt(text, below(text.size())) : Part{below(text.size()), 1 + below(40)};
  text.erase(at, size);
}

void Mutation::repeatPart(std::string& text) {
  const auto [at, size] = blockAt(text, below(text.size()));
  const std::string part = text.substr(at, size);
  for (std::size_t count = 1 + below(3); count > 0 && text.size() < kMaxSize; --count) text.insert(at, part + " ");
}

void Mutation::insertFromOther(std::string& text) {
  const std::string& other = corpus_[below(corpus_.size())];
  const auto [at, size] = blockAt(other, below(other.size()));
  const auto place = blockAt(text, below(text.size()));
  text.insert(place.first, other.substr(at, size) + " ");
}

/// A node with fields, which may be its own: words come as a node, and the fields of it after it.
void Mutation::insertNode(std::string& text) {
  static const std::vector<std::string> kValues = {"1",         "-1",          "0 0 0",      "1 2 3 4",
                                                   "[ ]",       "[ 0, 1, 2 ]", "\"a\"",      "USE x",
                                                   "1e9",       "TRUE",        "Cube { }",   "[ 0 0 0, 1 0 0, 1 1 0 ]",
                                                   "1000",      "NULL",        "[ 5, -1 ]",  "DEF x Separator { }",
                                                   "100000000", "32767",       "[ 0.5, 1 ]", "[ \"a\", \"b\" ]"};
  std::size_t word = below(words_.size());
  while (word > 0 && std::islower(static_cast<unsigned char>(words_[word].front()))) --word;
  std::string node = words_[word] + " { ";
  for (std::size_t field = word + 1; field < words_.size(); ++field) {
    if (std::isupper(static_cast<unsigned char>(words_[field].front()))) break;
    if (below(2) == 0) node += words_[field] + " " + kValues[below(kValues.size())] + " ";
  }
  const auto place = blockAt(text, below(text.size()));
  text.insert(place.first, node + "} ");
}

}  // namespace haptiv::testing
