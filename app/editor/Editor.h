#pragma once

#include <QAction>
#include <QObject>
#include <QWidget>
#include <memory>

#include "app/editor/document/SceneDocument.h"
#include "app/view/SceneView.h"

namespace haptiv {

/// Editing, as one thing to put into a window: the actions for menus and tool bars, the panels for docks, and the
/// handles in the view. Everything it does goes through the document's undo stack.
class Editor : public QObject {
  Q_OBJECT
 public:
  Editor(SceneDocument& document, SceneView& view, QObject* parent = nullptr);
  ~Editor() override;

  QAction* undo() const;
  QAction* redo() const;
  QAction* addWall() const;
  QAction* addDampingZone() const;
  QAction* addSpringZone() const;
  QAction* addRubberBand() const;
  QAction* makeSolid() const;  ///< for scenes that are only seen
  QAction* duplicate() const;
  QAction* remove() const;
  QAction* snapToGrid() const;  ///< checkable

  QWidget* sceneTree() const;
  QWidget* propertyPanel() const;
  QWidget* diagnosticsList() const;  ///< a click selects the node

  /// Off: no handles, nothing can be changed (a replay is shown).
  void setEnabled(bool enabled);

 private:
  void makeActions();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
