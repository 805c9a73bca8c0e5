#pragma once

#include "app/editor/document/SceneDocument.h"

namespace haptiv {

/// Several commands as one undo step.
class Macro {
 public:
  Macro(SceneDocument& document, const QString& text) : stack_(document.undoStack()) { stack_.beginMacro(text); }
  ~Macro() { stack_.endMacro(); }
  Macro(const Macro&) = delete;
  Macro& operator=(const Macro&) = delete;

 private:
  QUndoStack& stack_;
};

}  // namespace haptiv
