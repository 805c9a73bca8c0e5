#pragma once

#include <unordered_map>

#include "scenegraph/reading/text/SceneScan.h"

class SoNode;

namespace haptiv {

/// Which line each node stands on. Nodes of one type come in the order of the text; where Coin has made more or fewer
/// of a type than stand in the text (parts of node kits, prototypes), only named ones are told.
std::unordered_map<const SoNode*, int> findLines(const SceneScan& scan, SoNode* root, bool vrml2);

}  // namespace haptiv
