#include "scenegraph/reading/graph/IndexFaults.h"

#include <utility>

#include "scenegraph/Keyword.h"

namespace haptiv {

bool IndexFaults::hide(bool isHidden) {
  return std::exchange(isHidden_, isHidden);
}

void IndexFaults::add(const SoNode* node, std::string message, Diagnostic::Severity severity) {
  if (!said_.emplace(node, severity, isHidden_).second) return;
  const bool isError = severity == Diagnostic::Severity::error;
  (isError && isHidden_ ? hidden_ : faults_).push_back({severity, {}, 0, describe(node), std::move(message), node});
}

Diagnostics IndexFaults::take() {
  for (Diagnostic& fault : hidden_) {
    if (!sound_.contains(fault.source)) faults_.push_back(std::move(fault));
  }
  hidden_.clear();
  return std::exchange(faults_, {});
}

}  // namespace haptiv
