#pragma once

#include "scenegraph/Diagnostic.h"
#include "scenegraph/reading/text/SceneScan.h"

namespace haptiv {

/// Completes what Coin says, which mostly has a line and never a node: takes the node whose keyword or field the message
/// quotes, or the innermost one around the line; none where several could be meant. What has no line and names a
/// keyword or a prototype gets that of the first such one.
Diagnostics located(Diagnostics said, const SceneScan& scan, bool vrml2);

}  // namespace haptiv
