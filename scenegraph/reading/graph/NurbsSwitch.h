#pragma once

#include <vector>

class SoNode;

namespace haptiv {

/// Puts NURBS shapes without control points, which GLU must not be given, behind a Switch that shows none of its
/// children. They stay in the graph, and in the file when it is saved; one that a field held is gone.
/// @return  those shapes
std::vector<const SoNode*> switchOffEmptyNurbs(SoNode* root);

}  // namespace haptiv
