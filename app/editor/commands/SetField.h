#pragma once

#include "app/editor/commands/FieldValue.h"
#include "app/editor/commands/SceneCommand.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// Gives a field of a node another value.
class SetField : public SceneCommand {
 public:
  /// `field` belongs to `node`.
  SetField(SceneDocument& document, SoNode* node, SoField* field, FieldValue value, const QString& text,
           Gesture gesture = 0);

  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* next) override;

 protected:
  void apply() override { value_.exchangeWith(*field_); }
  void revert() override { value_.exchangeWith(*field_); }

 private:
  NodeRef<SoNode> node_;
  SoField* field_;
  FieldValue value_;  ///< the one that the field does not have
  Gesture gesture_;
};

}  // namespace haptiv
