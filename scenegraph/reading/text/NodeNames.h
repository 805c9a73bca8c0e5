#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace haptiv {

/// The words that go with DEF, USE and ROUTE, and which node a name stands for.
class NodeNames {
 public:
  /// Whether a word is one of those or goes with one; after USE, `used` is then the node that it names, if there is
  /// one.
  bool takes(std::string_view word);
  /// Whether a word must still follow.
  bool expectsWord() const { return expect_ != Expect::nothing; }
  /// Whether the last word that it took is the name after USE, and which node that is.
  bool isUse() const { return isUse_; }
  std::optional<std::size_t> used() const { return used_; }

  /// A node begins: it gets the name that stood before it, which is returned; empty: it has none.
  std::string begin(std::size_t node);
  /// Coin takes time that goes with the square of the number of names; from so many on it may be minutes.
  bool areVeryMany() const { return nodes_.size() > 50000; }

 private:
  enum class Expect { nothing, defName, useName, route };

  Expect expect_ = Expect::nothing;
  int routeWords_ = 0;
  std::string defName_;
  bool isUse_ = false;
  std::optional<std::size_t> used_;
  std::unordered_map<std::string, std::size_t> nodes_;  ///< the last one of each name
};

}  // namespace haptiv
