#pragma once

#include <Inventor/nodes/SoGroup.h>

#include "app/editor/commands/SceneCommand.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// Takes one child out of a group. Where the same node stands elsewhere too (USE), it stays there.
class RemoveNode : public SceneCommand {
 public:
  RemoveNode(SceneDocument& document, SoGroup* parent, int index, const QString& text)
      : SceneCommand(document, text), parent_(parent), node_(parent->getChild(index)), index_(index) {}

 protected:
  void apply() override { parent_->removeChild(index_); }
  void revert() override { parent_->insertChild(node_.get(), index_); }

 private:
  NodeRef<SoGroup> parent_;
  NodeRef<SoNode> node_;
  int index_;
};

}  // namespace haptiv
