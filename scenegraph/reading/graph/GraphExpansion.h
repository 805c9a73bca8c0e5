#pragma once

#include <string>

class SoNode;

namespace haptiv {

/// Why a graph is too large for actions, which visit a node once for every way to it, and where.
struct GraphFault {
  std::string why;               ///< empty where it is not
  const SoNode* node = nullptr;  ///< of which it is so first
};

/// 500 bytes of USE within USE can make millions of triangles, and a cycle never ends. Visits each node once.
GraphFault expansionFault(SoNode* root);

}  // namespace haptiv
