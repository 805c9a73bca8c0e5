#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace haptiv {

/// Follows PROTO NAME [ ... ] { ... } and EXTERNPROTO NAME [ ... ] URLS through a text, and counts the nodes that
/// prototypes come to: Coin writes out every use of one while it reads, so that a few lines of prototypes within
/// prototypes fill the memory, and one that holds itself never ends.
class Prototypes {
 public:
  /// Whether a word belongs to the declaration of a prototype.
  bool takesWord(std::string_view word);
  /// Whether the last such word was its name.
  bool isNamed() const { return phase_ == Phase::fields || phase_ == Phase::externFields; }
  void takeString(std::size_t depth);
  /// "[" and "{", `depth` brackets being open before it; whether it opens the body of a prototype.
  void openList(std::size_t depth);
  bool opensBody(std::size_t depth);
  void closeBody();

  /// Within a declaration, where a bracket or string is still to come.
  bool isOpen() const { return phase_ != Phase::none; }

  /// A node in the text. Why it may not stand there; empty where it may.
  std::string add(std::string_view keyword);

 private:
  enum class Phase { none, name, fields, body, externName, externFields, externUrls };
  struct Body {
    std::string name;
    double nodes = 0;
  };
  Phase phase_ = Phase::none;
  std::string name_;
  std::size_t depth_ = 0;   ///< of the brackets around the declaration
  std::vector<Body> open_;  ///< bodies that the text is in, the innermost last
  std::unordered_map<std::string, double> size_;
  double nodes_ = 0;  ///< in the scene itself
};

}  // namespace haptiv
