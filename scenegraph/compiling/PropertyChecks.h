#pragma once

#include <string>
#include <vector>

#include "scenegraph/Diagnostic.h"

class SoNode;

namespace haptiv {

/// What is wrong with a field's value.
struct FieldFault {
  Diagnostic::Severity severity = Diagnostic::Severity::error;
  std::string message;
};

/// Holds the fields of a haptic node against their ranges. Other nodes have no faults.
std::vector<FieldFault> checkFields(const SoNode* node);

}  // namespace haptiv
