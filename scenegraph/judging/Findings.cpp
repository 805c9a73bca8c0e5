#include "scenegraph/judging/Findings.h"

#include <cmath>
#include <cstdio>

#include "scenegraph/Keyword.h"

namespace haptiv {

Diagnostics Findings::take() && {
  if (more_ > 0) {
    Diagnostic last = found_.back();
    last.message = "and " + std::to_string(more_) + " more such places: mend these first, then check again";
    found_.push_back(std::move(last));
  }
  return std::move(found_);
}

void Findings::add(Diagnostic::Severity severity, const SoNode* node, std::string message) {
  if (found_.size() >= kMost) {
    ++more_;
    return;
  }
  found_.push_back({severity, {}, 0, node ? describe(node) : std::string(), std::move(message), node});
}

std::string lengthText(double metres) {
  char text[48];
  const bool isSmall = std::abs(metres) < 1;
  std::snprintf(text, sizeof text, isSmall ? "%.3g mm" : "%.3g m", isSmall ? 1000 * metres : metres);
  return text;
}

}  // namespace haptiv
