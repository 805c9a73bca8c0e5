#pragma once

#include <Inventor/nodes/SoTransform.h>

#include <array>

#include "app/editor/commands/FieldValue.h"
#include "app/editor/commands/SceneCommand.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// Where an SoTransform puts what follows it, as far as the editor changes it.
struct TransformValue {
  SbVec3f translation{0, 0, 0};
  SbRotation rotation = SbRotation::identity();
  SbVec3f scaleFactor{1, 1, 1};

  static TransformValue of(const SoTransform& node);
  bool operator==(const TransformValue&) const = default;
};

/// Moves, turns and resizes at once. A field that stays as it is is not touched.
class SetTransform : public SceneCommand {
 public:
  SetTransform(SceneDocument& document, SoTransform* node, const TransformValue& value, const QString& text,
               Gesture gesture = 0);

  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* next) override;

 protected:
  void apply() override { exchange(); }
  void revert() override { exchange(); }

 private:
  std::array<SoField*, 3> fields() const;
  void exchange();

  NodeRef<SoTransform> node_;
  std::array<FieldValue, 3> values_;  ///< those that the node does not have
  Gesture gesture_;
};

}  // namespace haptiv
