#pragma once

#include <cstddef>
#include <vector>

#include "haptics/index/BoxNode.h"
#include "haptics/index/TreePlan.h"

namespace haptiv {

/// Levels of nodes that a tree has at most.
inline constexpr std::size_t kMaxTreeDepth = 40;

/// Groups boxes into a tree by the surface-area heuristic: a box is as likely to be touched as it is large. The root
/// comes first, each node before those below it, and these before those below the next place. Item i is boxes[i].
/// O(n log n); the same boxes give the same tree.
/// @param plan  how it came to be is put there, where it is wanted
std::vector<BoxNode> buildNodes(const std::vector<FloatBox>& boxes, TreePlan* plan = nullptr);

/// The same tree in a fifth of the time, where most boxes are those of a tree before, in the same order: only what a
/// changed box stands below is built anew.
/// @param items  all of them, in any order; those that are new say so, the others have the boxes that they had before
std::vector<BoxNode> rebuildNodes(std::vector<SplitItem> items, const TreeBefore& before, TreePlan& plan);

}  // namespace haptiv
