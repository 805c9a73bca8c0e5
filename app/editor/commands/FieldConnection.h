#pragma once

#include <Inventor/engines/SoEngineOutput.h>
#include <Inventor/fields/SoField.h>

#include "scenegraph/NodeRef.h"

namespace haptiv {

/// Where a field has its value from: a prototype's field (IS), another one, or an engine. A value that is set while it
/// is connected would be lost when the scene is written.
class FieldConnection {
 public:
  FieldConnection() = default;
  /// Disconnects the field, which keeps its value.
  static FieldConnection cut(SoField& field);
  void restore(SoField& field) const;

 private:
  SoField* field_ = nullptr;
  SoEngineOutput* output_ = nullptr;
  NodeRef<SoFieldContainer> holder_;  ///< of either
};

}  // namespace haptiv
