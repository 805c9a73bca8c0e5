#pragma once

#include <set>
#include <string>
#include <tuple>
#include <unordered_set>

#include "scenegraph/Diagnostic.h"

namespace haptiv {

/// What has been found wrong with the shapes of a graph, once a node.
///
/// Many files keep shapes behind a Switch that shows none, and use them elsewhere, after the coordinates: what is right
/// there may be wrong here.
class IndexFaults {
 public:
  /// From now on, what is met stands behind a Switch, or does not. Returns whether it did before.
  bool hide(bool isHidden);
  bool isHidden() const { return isHidden_; }

  void add(const SoNode* node, std::string message, Diagnostic::Severity severity);
  /// The shape is right in one place at least.
  void noteSound(const SoNode* node) { sound_.insert(node); }

  /// All of them, but for the errors of hidden shapes that are right elsewhere.
  Diagnostics take();

 private:
  bool isHidden_ = false;
  Diagnostics faults_;
  Diagnostics hidden_;
  std::unordered_set<const SoNode*> sound_;
  std::set<std::tuple<const SoNode*, Diagnostic::Severity, bool>> said_;
};

}  // namespace haptiv
