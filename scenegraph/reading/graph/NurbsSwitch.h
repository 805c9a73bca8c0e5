#pragma once

#include <vector>

class SoNode;

namespace haptiv {

/// Puts each NURBS shape behind a Switch that shows none of its children: Coin crashes where it makes triangles of
/// NURBS without a display. They stay in the graph, and in the file when it is saved; one that a field held is gone.
/// @return  those shapes
std::vector<const SoNode*> switchOffNurbs(SoNode* root);

}  // namespace haptiv
