#pragma once

#include <vector>

class SoNode;

namespace haptiv {

/// Cuts the NURBS surfaces of a scene wherever a profile trims them, behind a Switch or LOD too. All of it takes some
/// 10 s at most. The scene must be sound.
/// @return  surfaces of which GLU has made nothing in some place
std::vector<const SoNode*> cutTrimmedNurbs(SoNode* root);

}  // namespace haptiv
