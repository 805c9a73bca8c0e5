#pragma once

#include <Inventor/nodes/SoGroup.h>

#include "app/editor/commands/SceneCommand.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// Puts a node among a group's children.
class InsertNode : public SceneCommand {
 public:
  /// @param index  where it will stand among the children
  InsertNode(SceneDocument& document, SoGroup* parent, int index, SoNode* node, const QString& text)
      : SceneCommand(document, text), parent_(parent), node_(node), index_(index) {}

 protected:
  void apply() override { parent_->insertChild(node_.get(), index_); }
  void revert() override { parent_->removeChild(index_); }

 private:
  NodeRef<SoGroup> parent_;
  NodeRef<SoNode> node_;
  int index_;
};

}  // namespace haptiv
