#pragma once

#include <Inventor/SoPath.h>
#include <Inventor/nodes/SoSeparator.h>

#include "scenegraph/NodeRef.h"

namespace haptiv {

/// One selected node, followed through edits of the graph around it: Coin shifts a path's indices as siblings come and
/// go; where the node was wrapped or moved, it is looked for again.
class Selection {
 public:
  void set(const SoPath* path);
  /// From the root to the node; null: nothing is selected, or the node is no longer in this graph.
  const SoPath* resolve(SoSeparator* root);
  bool isEmpty() const { return !node_; }

 private:
  bool isIntact(SoSeparator* root) const;

  NodeRef<SoPath> path_;
  NodeRef<SoNode> node_;
};

}  // namespace haptiv
