#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace haptiv {

/// Follows `fields [ TYPE NAME, ... ]` and `inputs [ ... ]` of nodes through a text. Coin crashes where a node that it
/// knows declares a field that it has not: a newer file in an older program.
class DeclaredFields {
 public:
  explicit DeclaredFields(bool vrml2) : vrml2_(vrml2) {}

  /// A list begins. @param word  before it
  void openList(std::string_view word, bool isInNode) {
    isOpen_ = isInNode && (word == "fields" || word == "inputs");
    words_.clear();
  }
  void take(std::string_view word) {
    if (isOpen_) words_.emplace_back(word);
  }
  /// A bracket closes. Why what a node of this keyword has declared may not be read; empty where it may.
  std::string close(const std::string& keyword);

 private:
  bool vrml2_;
  bool isOpen_ = false;
  std::vector<std::string> words_;  ///< TYPE, NAME, TYPE, NAME, ...
};

/// Whether nodes of this keyword have a field of one of these names.
bool hasFieldOf(const std::string& keyword, bool vrml2, const std::set<std::string>& names);

}  // namespace haptiv
