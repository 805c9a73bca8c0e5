#include "app/editor/commands/SetTransform.h"

namespace haptiv {
namespace {

template <typename Field, typename Value>
FieldValue changed(const Field& field, const Value& value) {
  return field.getValue() == value ? FieldValue(field) : FieldValue::of<Field>(field, value);
}

}  // namespace

TransformValue TransformValue::of(const SoTransform& node) {
  return {node.translation.getValue(), node.rotation.getValue(), node.scaleFactor.getValue()};
}

SetTransform::SetTransform(SceneDocument& document, SoTransform* node, const TransformValue& value, const QString& text,
                           Gesture gesture)
    : SceneCommand(document, text),
      node_(node),
      values_{changed(node->translation, value.translation), changed(node->rotation, value.rotation),
              changed(node->scaleFactor, value.scaleFactor)},
      gesture_(gesture) {}

std::array<SoField*, 3> SetTransform::fields() const {
  return {&node_->translation, &node_->rotation, &node_->scaleFactor};
}

void SetTransform::exchange() {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i].exchangeWith(*fields()[i]);
}

bool SetTransform::mergeWith(const QUndoCommand* next) {
  const auto* other = dynamic_cast<const SetTransform*>(next);
  if (!other || gesture_ == 0 || other->gesture_ != gesture_ || other->node_.get() != node_.get()) return false;
  if (other->text() != text()) return false;  // a move and a turn are two steps
  bool isSame = true;
  for (std::size_t i = 0; i < values_.size(); ++i) isSame = isSame && values_[i].isSameAs(*fields()[i]);
  setObsolete(isSame);
  return true;
}

}  // namespace haptiv
