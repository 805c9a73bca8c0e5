#pragma once

class SoSeparator;

namespace haptiv {

/// Whether the graph holds nodes of other files, by a File or Inline.
bool includesFiles(SoSeparator* root);

/// Puts what files brought in the place of the nodes that name them. For a process of its own (runIsolated), or a graph
/// of one's own.
void writeOutIncluded(SoSeparator* root);

}  // namespace haptiv
