#include "scenegraph/Diagnostic.h"

#include <algorithm>
#include <tuple>

namespace haptiv {

void locate(Diagnostics& diagnostics, const std::unordered_map<const SoNode*, int>& lineOf, const std::string& file) {
  for (Diagnostic& diagnostic : diagnostics) {
    diagnostic.file = file;
    const auto line = lineOf.find(diagnostic.source);
    if (line != lineOf.end()) diagnostic.line = line->second;
  }
}

void sortByPlace(Diagnostics& diagnostics) {
  std::ranges::stable_sort(diagnostics, [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.severity, a.file, a.line) < std::tie(b.severity, b.file, b.line);
  });
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::ranges::any_of(diagnostics,
                             [](const Diagnostic& d) { return d.severity == Diagnostic::Severity::error; });
}

std::string toText(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line > 0) text += ":" + std::to_string(diagnostic.line);
  text += diagnostic.severity == Diagnostic::Severity::error ? ": error: " : ": warning: ";
  if (!diagnostic.node.empty()) text += diagnostic.node + ": ";
  return text + diagnostic.message;
}

}  // namespace haptiv
