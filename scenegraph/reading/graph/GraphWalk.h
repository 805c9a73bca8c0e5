#pragma once

#include <string>
#include <vector>

class SoNode;

namespace haptiv {

/// The nodes right below a node that stand in its text: children of a group, and nodes held by fields.
std::vector<SoNode*> writtenChildren(const SoNode* node);

/// Every node that stands in the text of a graph, once, in the order of the text.
std::vector<SoNode*> writtenNodes(SoNode* root);

/// Why a graph is too large for actions, which visit a node once for every way to it, and where.
struct GraphFault {
  std::string why;               ///< empty where it is not
  const SoNode* node = nullptr;  ///< of which it is so first
};

/// 500 bytes of USE within USE can make millions of triangles, and a cycle never ends. Visits each node once.
GraphFault expansionFault(SoNode* root);

}  // namespace haptiv
