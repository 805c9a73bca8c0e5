#pragma once

#include <cstddef>
#include <vector>

#include "haptics/index/BoxNode.h"

namespace haptiv {

/// Levels of nodes that a tree has at most.
inline constexpr std::size_t kMaxTreeDepth = 40;

/// Groups boxes into a tree by the surface-area heuristic: a box is as likely to be touched as it is large. The root
/// comes first, children after their parents. Item i is boxes[i]. O(n log n); the same boxes give the same tree.
std::vector<BoxNode> buildNodes(const std::vector<FloatBox>& boxes);

}  // namespace haptiv
