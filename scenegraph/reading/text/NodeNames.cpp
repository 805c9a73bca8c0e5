#include "scenegraph/reading/text/NodeNames.h"

#include <utility>

namespace haptiv {

bool NodeNames::takes(std::string_view word) {
  used_.reset();
  isUse_ = expect_ == Expect::useName;
  if (expect_ == Expect::nothing) {
    if (word == "DEF") expect_ = Expect::defName;
    if (word == "USE") expect_ = Expect::useName;
    if (word == "ROUTE") expect_ = Expect::route;  // ROUTE from TO to
    routeWords_ = 3;
    return expect_ != Expect::nothing;
  }
  if (expect_ == Expect::defName) defName_ = word;
  if (isUse_) {
    if (const auto found = nodes_.find(std::string(word)); found != nodes_.end()) used_ = found->second;
  }
  if (expect_ != Expect::route || --routeWords_ == 0) expect_ = Expect::nothing;
  return true;
}

std::string NodeNames::begin(std::size_t node) {
  if (!defName_.empty()) nodes_[defName_] = node;
  return std::exchange(defName_, {});
}

}  // namespace haptiv
