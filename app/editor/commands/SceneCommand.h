#pragma once

#include <QUndoCommand>

#include "app/editor/document/SceneDocument.h"

namespace haptiv {

/// A change of the document's graph that can be taken back. Nothing outside the commands writes to the graph.
class SceneCommand : public QUndoCommand {
 public:
  SceneCommand(SceneDocument& document, const QString& text) : QUndoCommand(text), document_(document) {}

  void redo() final { change(&SceneCommand::apply); }
  void undo() final { change(&SceneCommand::revert); }

 protected:
  virtual void apply() = 0;
  virtual void revert() = 0;

 private:
  void change(void (SceneCommand::*step)()) {
    document_.releaseHandles();
    (this->*step)();
    document_.noteChange();
  }

  SceneDocument& document_;
};

/// The edits of one gesture merge into one undo step: a spin box that runs, a handle that is dragged. 0: never merge.
using Gesture = int;

}  // namespace haptiv
