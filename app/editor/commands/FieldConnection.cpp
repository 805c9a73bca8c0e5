#include "app/editor/commands/FieldConnection.h"

#include <Inventor/engines/SoEngine.h>
#include <Inventor/engines/SoNodeEngine.h>

namespace haptiv {

FieldConnection FieldConnection::cut(SoField& field) {
  FieldConnection was;
  if (!field.isConnected()) return was;
  if (field.getConnectedField(was.field_)) {
    was.holder_ = NodeRef<SoFieldContainer>(was.field_->getContainer());
  } else if (field.getConnectedEngine(was.output_)) {
    SoFieldContainer* engine = was.output_->getContainer();
    if (was.output_->isNodeEngineOutput()) engine = was.output_->getNodeContainer();
    was.holder_ = NodeRef<SoFieldContainer>(engine);
  }
  field.disconnect();
  return was;
}

void FieldConnection::restore(SoField& field) const {
  if (field_) field.connectFrom(field_);
  if (output_) field.connectFrom(output_);
}

}  // namespace haptiv
