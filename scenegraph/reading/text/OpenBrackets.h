#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "scenegraph/reading/text/SceneScan.h"
#include "scenegraph/reading/text/SceneTokenizer.h"

namespace haptiv {

/// The brackets that are open at a place of a scene's text, and what they say of that place.
class OpenBrackets {
 public:
  struct Bracket {
    SceneToken::Kind kind = SceneToken::Kind::open;
    int line = 0;
    std::size_t node = TextNode::kNone;  ///< that it is of
    bool isBody = false;                 ///< of a prototype
    bool isApart = false;                ///< what stands in it is no part of the scene where it stands
    std::string_view field = {};         ///< the word before a list
  };

  bool empty() const { return open_.empty(); }
  std::size_t count() const { return open_.size(); }
  void open(const Bracket& bracket) { open_.push_back(bracket); }
  void close() { open_.pop_back(); }
  const Bracket& innermost() const { return open_.back(); }

  /// The node that the place is in; TextNode::kNone at the top.
  std::size_t node() const {
    const auto own = std::find_if(open_.rbegin(), open_.rend(),
                                  [](const Bracket& bracket) { return bracket.node != TextNode::kNone; });
    return own == open_.rend() ? TextNode::kNone : own->node;
  }

  bool isWithin(std::size_t node) const {
    return std::ranges::any_of(open_, [node](const Bracket& bracket) { return bracket.node == node; });
  }

  bool isApart() const { return !open_.empty() && open_.back().isApart; }

  /// Which field a node stands in, by the word before it: in a list, that of the list.
  std::string_view fieldBefore(std::string_view word) const {
    const bool isInList = !open_.empty() && open_.back().kind == SceneToken::Kind::openList;
    return isInList ? open_.back().field : word;
  }

 private:
  std::vector<Bracket> open_;
};

}  // namespace haptiv
