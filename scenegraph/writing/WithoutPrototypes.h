#pragma once

#include "scenegraph/NodeRef.h"

class SoSeparator;

namespace haptiv {

/// A copy of the graph in which what prototypes made stands as plain nodes, and the prototypes themselves do not. Coin
/// writes prototypes so that they are lost when what it wrote is read and written again; this it writes well. Values
/// that were the prototype's (IS) are those of now. Throws std::runtime_error where it cannot be done.
NodeRef<SoSeparator> withoutPrototypes(SoSeparator* root);

}  // namespace haptiv
