#pragma once

#include <string>

#include "scenegraph/Diagnostic.h"

class SoNode;

namespace haptiv {

/// What one rule finds. Beyond kMost it only counts, so that ten thousand thin walls are no ten thousand lines.
class Findings {
 public:
  static constexpr int kMost = 20;

  void error(const SoNode* node, std::string message) { add(Diagnostic::Severity::error, node, std::move(message)); }
  void warn(const SoNode* node, std::string message) { add(Diagnostic::Severity::warning, node, std::move(message)); }
  /// All of it, with a last line for what was only counted.
  Diagnostics take() &&;

 private:
  void add(Diagnostic::Severity severity, const SoNode* node, std::string message);

  Diagnostics found_;
  int more_ = 0;
};

/// A length as a person says it: "5 mm", "1.2 m".
std::string lengthText(double metres);

}  // namespace haptiv
