#pragma once

#include <vector>

class SoNode;

namespace haptiv {

/// Puts the NURBS shapes that GLU must not be given behind a Switch that shows none of its children: empty ones, and
/// all where a scene has profiles, which may trim them: GLU does not end, or crashes, on some loops, depending on from
/// where they are seen. They stay in the graph, and in the file when it is saved; one that a field held is gone.
/// @return  those shapes
std::vector<const SoNode*> switchOffNurbs(SoNode* root);

}  // namespace haptiv
