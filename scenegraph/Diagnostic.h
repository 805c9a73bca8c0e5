#pragma once

#include <string>
#include <unordered_map>
#include <vector>

class SoNode;

namespace haptiv {

/// One thing that is wrong, or doubtful, about a scene: what, where, and what to do.
struct Diagnostic {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  std::string file;
  int line = 0;                    ///< 1-based; 0: not known
  std::string node;                ///< the node's keyword and, where it has one, its label or DEF name
  std::string message;             ///< what is wrong and what to change, one sentence
  const SoNode* source = nullptr;  ///< for finding the node in the scene that was read; never dereferenced
};
using Diagnostics = std::vector<Diagnostic>;

/// Fills in the file, and the lines of the nodes that have one.
void locate(Diagnostics& diagnostics, const std::unordered_map<const SoNode*, int>& lineOf, const std::string& file);
/// Errors first, each by file and line; what has no line stands before what has.
void sortByPlace(Diagnostics& diagnostics);
bool hasErrors(const Diagnostics& diagnostics);
/// "FILE:LINE: error: NODE: MESSAGE"
std::string toText(const Diagnostic& diagnostic);

}  // namespace haptiv
