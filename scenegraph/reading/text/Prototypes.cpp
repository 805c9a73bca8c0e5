#include "scenegraph/reading/text/Prototypes.h"

#include <algorithm>

namespace haptiv {
namespace {

constexpr double kMaxNodes = 3e6;  // about a gigabyte

}  // namespace

bool Prototypes::takesWord(std::string_view word) {
  if (phase_ == Phase::name || phase_ == Phase::externName) {
    name_ = word;
    phase_ = phase_ == Phase::name ? Phase::fields : Phase::externFields;
  } else if (word == "PROTO") {
    phase_ = Phase::name;
  } else if (word == "EXTERNPROTO") {
    phase_ = Phase::externName;
  } else {
    return false;
  }
  return true;
}

void Prototypes::takeString(std::size_t depth) {
  if (phase_ == Phase::externUrls && depth == depth_) phase_ = Phase::none;
}

void Prototypes::openList(std::size_t depth) {
  if (phase_ == Phase::fields || phase_ == Phase::externFields) {
    depth_ = depth;
    phase_ = phase_ == Phase::fields ? Phase::body : Phase::externUrls;
  } else if (phase_ == Phase::externUrls && depth == depth_) {
    phase_ = Phase::none;
  }
}

bool Prototypes::opensBody(std::size_t depth) {
  if (phase_ != Phase::body || depth != depth_) return false;
  phase_ = Phase::none;
  open_.push_back({name_, 0});
  return true;
}

void Prototypes::closeBody() {
  size_[open_.back().name] = open_.back().nodes;
  open_.pop_back();
}

std::string Prototypes::add(std::string_view keyword) {
  const auto isIt = [&](const Body& body) { return body.name == keyword; };
  if (std::ranges::any_of(open_, isIt)) return "the prototype stands inside itself: remove it there";
  const auto prototype = size_.find(std::string(keyword));
  double& nodes = open_.empty() ? nodes_ : open_.back().nodes;
  nodes += prototype == size_.end() ? 1 : prototype->second + 1;
  if (nodes > kMaxNodes) return "the prototypes come to more than 3 million nodes: use fewer of them";
  return {};
}

}  // namespace haptiv
