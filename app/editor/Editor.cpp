#include "app/editor/Editor.h"

#include <QPointer>
#include <QUndoStack>

#include "app/editor/EditorIcons.h"
#include "app/editor/edits/Edits.h"
#include "app/editor/handles/Handles.h"
#include "app/editor/panels/DiagnosticsList.h"
#include "app/editor/panels/PropertyPanel.h"
#include "app/editor/panels/SceneTree.h"

namespace haptiv {

struct Editor::Parts {
  Parts(SceneDocument& edited, SceneView& shown)
      : document(edited),
        view(shown),
        handles(edited),
        tree(new SceneTree(edited)),
        panel(new PropertyPanel(edited)),
        diagnostics(new DiagnosticsList(edited)) {}
  // A window that has taken a panel in deletes it; one that nobody took is ours.
  ~Parts() {
    for (const QPointer<QWidget>& widget : {tree, panel, diagnostics}) {
      if (widget && !widget->parent()) delete widget;
    }
  }

  SceneDocument& document;
  SceneView& view;
  Handles handles;
  QPointer<QWidget> tree, panel, diagnostics;
  QAction *undo = nullptr, *redo = nullptr, *wall = nullptr, *dampingZone = nullptr, *springZone = nullptr,
          *rubberBand = nullptr, *makeSolid = nullptr, *duplicate = nullptr, *remove = nullptr, *snap = nullptr;
  bool isEnabled = true;

  void updateUndo() {
    const bool canEdit = isEnabled && !handles.isDragging();
    const QUndoStack& stack = document.undoStack();
    undo->setEnabled(canEdit && stack.canUndo());
    redo->setEnabled(canEdit && stack.canRedo());
    undo->setText(stack.canUndo() ? QString("&Undo %1").arg(stack.undoText()) : QString("&Undo"));
    redo->setText(stack.canRedo() ? QString("&Redo %1").arg(stack.redoText()) : QString("&Redo"));
  }

  void updateActions() {
    updateUndo();
    const bool canEdit = isEnabled && !handles.isDragging();
    const std::vector<SceneItem> items = listScene(document.root(), Naming::none);
    const SceneItem* item = findItem(items, document.selection());
    remove->setEnabled(canEdit && item && item->kind != SceneItem::Kind::tool && item->kind != SceneItem::Kind::device);
    duplicate->setEnabled(remove->isEnabled() && canDuplicate(document));
    for (QAction* action : {wall, dampingZone, springZone, rubberBand}) action->setEnabled(canEdit);
    makeSolid->setEnabled(canEdit && isScenery(items));
  }
};

namespace {

QAction* makeAction(QObject* owner, const QString& name, EditorIcon icon, const QString& text, const QString& tip,
                    const QKeySequence& shortcut) {
  auto* action = new QAction(editorIcon(icon), text, owner);
  action->setObjectName(name);
  action->setShortcut(shortcut);
  action->setToolTip(shortcut.isEmpty() ? tip
                                        : QString("%1 (%2)").arg(tip, shortcut.toString(QKeySequence::NativeText)));
  return action;
}

}  // namespace

Editor::Editor(SceneDocument& document, SceneView& view, QObject* parent)
    : QObject(parent), parts_(std::make_unique<Parts>(document, view)) {
  Parts& parts = *parts_;
  makeActions();
  const auto update = [this] { parts_->updateActions(); };
  connect(&document, &SceneDocument::selectionChanged, this, update);
  connect(&document, &SceneDocument::sceneChanged, this, update);
  connect(&document, &SceneDocument::sceneReplaced, this, update);
  // The scene is felt before all of it is looked through: sceneChanged is still to come.
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this] { parts_->updateUndo(); });
  connect(&parts.handles, &Handles::draggingChanged, this, update);
  connect(&view, &SceneView::shapeClicked, this, [this](const SoPath* path) {
    if (parts_->handles.isDragging()) return;
    parts_->document.select(path);
  });
  update();
}

Editor::~Editor() = default;

void Editor::makeActions() {
  Parts& parts = *parts_;
  QUndoStack& stack = parts.document.undoStack();
  parts.undo = makeAction(this, "undoAction", EditorIcon::undo, "&Undo", "Undo the last edit", QKeySequence("Ctrl+Z"));
  parts.redo =
      makeAction(this, "redoAction", EditorIcon::redo, "&Redo", "Redo what was undone", QKeySequence("Ctrl+Shift+Z"));
  parts.wall =
      makeAction(this, "addWallAction", EditorIcon::wall, "Add &wall", "Add a wall beside the ball", QKeySequence("W"));
  parts.dampingZone = makeAction(this, "addDampingZoneAction", EditorIcon::dampingZone, "Add &damping zone",
                                 "Add a zone that brakes the hand", QKeySequence("D"));
  parts.springZone = makeAction(this, "addSpringZoneAction", EditorIcon::springZone, "Add &spring zone",
                                "Add a zone that draws the hand to its middle", QKeySequence("S"));
  parts.rubberBand =
      makeAction(this, "addRubberBandAction", EditorIcon::rubberBand, "Add &rubber band",
                 "Add a zone that draws the hand back from farther than its rest length", QKeySequence("R"));
  parts.makeSolid =
      makeAction(this, "makeSolidAction", EditorIcon::makeSolid, "&Make solid",
                 "Make everything that is seen felt: adds a ball and a surface of the model's size", QKeySequence("M"));
  parts.duplicate = makeAction(this, "duplicateAction", EditorIcon::duplicate, "D&uplicate",
                               "Put a copy of what is selected beside it", QKeySequence("Ctrl+D"));
  parts.remove = makeAction(this, "removeAction", EditorIcon::remove, "&Delete", "Delete what is selected",
                            QKeySequence(Qt::Key_Delete));
  parts.snap = makeAction(this, "snapToGridAction", EditorIcon::grid, "Snap to &grid",
                          "Moved edges snap to a grid of 1 cm", QKeySequence("G"));
  parts.snap->setCheckable(true);
  parts.snap->setChecked(true);

  connect(parts.undo, &QAction::triggered, &stack, &QUndoStack::undo);
  connect(parts.redo, &QAction::triggered, &stack, &QUndoStack::redo);
  const auto adds = [this](QAction* action, SceneItem::Kind kind) {
    connect(action, &QAction::triggered, this, [this, kind] { addShape(parts_->document, kind); });
  };
  adds(parts.wall, SceneItem::Kind::wall);
  adds(parts.dampingZone, SceneItem::Kind::dampingZone);
  adds(parts.springZone, SceneItem::Kind::springZone);
  adds(parts.rubberBand, SceneItem::Kind::rubberBand);
  connect(parts.makeSolid, &QAction::triggered, this, [this] { haptiv::makeSolid(parts_->document); });
  connect(parts.duplicate, &QAction::triggered, this, [this] { duplicateShape(parts_->document); });
  connect(parts.remove, &QAction::triggered, this, [this] { removeShape(parts_->document); });
  connect(parts.snap, &QAction::toggled, this, [this](bool on) { parts_->handles.setSnapping(on); });
}

QAction* Editor::undo() const {
  return parts_->undo;
}
QAction* Editor::redo() const {
  return parts_->redo;
}
QAction* Editor::addWall() const {
  return parts_->wall;
}
QAction* Editor::addDampingZone() const {
  return parts_->dampingZone;
}
QAction* Editor::addSpringZone() const {
  return parts_->springZone;
}
QAction* Editor::addRubberBand() const {
  return parts_->rubberBand;
}
QAction* Editor::makeSolid() const {
  return parts_->makeSolid;
}
QAction* Editor::duplicate() const {
  return parts_->duplicate;
}
QAction* Editor::remove() const {
  return parts_->remove;
}
QAction* Editor::snapToGrid() const {
  return parts_->snap;
}
QWidget* Editor::sceneTree() const {
  return parts_->tree;
}
QWidget* Editor::propertyPanel() const {
  return parts_->panel;
}
QWidget* Editor::diagnosticsList() const {
  return parts_->diagnostics;
}

void Editor::setEnabled(bool enabled) {
  parts_->isEnabled = enabled;
  parts_->handles.setEnabled(enabled);
  parts_->panel->setEnabled(enabled);
  parts_->updateActions();
}

}  // namespace haptiv

#include "moc_Editor.cpp"
