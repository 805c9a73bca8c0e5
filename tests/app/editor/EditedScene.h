#pragma once

#include <QTemporaryDir>
#include <string>

#include "app/editor/document/SceneDocument.h"
#include "app/editor/edits/Edits.h"
#include "app/editor/items/SceneItems.h"

namespace haptiv {

/// A document opened from text, and what tests ask of it.
class EditedScene {
 public:
  explicit EditedScene(const std::string& text);

  SceneDocument document;

  QString pathOf(const QString& fileName) const { return folder_.filePath(fileName); }
  /// Selects what the scene tree calls so; false: there is none.
  bool select(const QString& name);
  std::vector<SceneItem> items() const { return listScene(document.root()); }
  QStringList names() const;

 private:
  QTemporaryDir folder_;
};

/// For an SoSFFloat.
NewValue number(float value);

/// Lets the event loop turn until nothing is waiting.
void letEventsRun();

/// A tool at the origin, and two walls with transforms and properties of their own.
extern const char kTwoWalls[];
/// Three walls that share one property; the second is a bare Cube without a transform, beside the others.
extern const char kSharedProperty[];

}  // namespace haptiv
