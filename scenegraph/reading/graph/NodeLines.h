#pragma once

#include <unordered_map>

#include "scenegraph/reading/text/SceneScan.h"

class SoNode;
class SoSeparator;

namespace haptiv {

/// 1-based.
using NodeLines = std::unordered_map<const SoNode*, int>;

/// Which line each node stands on, by its place among its neighbours in text and graph. What Coin makes of a node (a
/// prototype's nodes, parts of a dragger) has the line of that node. A node whose place is not certain has none, or
/// that of the node around it; a root that does not stand in the text has that of the first node.
NodeLines findLines(const SceneScan& scan, SoSeparator* root, bool vrml2);

}  // namespace haptiv
