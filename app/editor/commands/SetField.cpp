#include "app/editor/commands/SetField.h"

namespace haptiv {

SetField::SetField(SceneDocument& document, SoNode* node, SoField* field, FieldValue value, const QString& text,
                   Gesture gesture)
    : SceneCommand(document, text), node_(node), field_(field), value_(std::move(value)), gesture_(gesture) {}

bool SetField::mergeWith(const QUndoCommand* next) {
  const auto* other = dynamic_cast<const SetField*>(next);
  if (!other || gesture_ == 0 || other->gesture_ != gesture_ || other->field_ != field_) return false;
  setObsolete(value_.isSameAs(*field_));
  return true;
}

}  // namespace haptiv
