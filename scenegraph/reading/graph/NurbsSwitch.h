#pragma once

#include <vector>

class SoNode;

namespace haptiv {

/// Where a scene has profiles, which may trim NURBS, puts each NURBS shape behind a Switch that shows none of its
/// children: GLU does not end, or crashes, on some loops, depending on from where they are seen. They stay in the
/// graph, and in the file when it is saved; one that a field held is gone.
/// @return  those shapes
std::vector<const SoNode*> switchOffTrimmedNurbs(SoNode* root);

}  // namespace haptiv
