#pragma once

class SoSeparator;

namespace haptiv {

/// Makes plain nodes of what prototypes made, and takes the prototypes away. Coin writes prototypes so that they are
/// lost when what it wrote is read and written again, and copies what they made as it was before it was edited; plain
/// nodes it writes well. Values that were the prototype's (IS) are those of now. What else holds on to a prototype's
/// instance is left with nothing: only for a process of its own (runIsolated).
void writeOutPrototypes(SoSeparator* root);

}  // namespace haptiv
