#pragma once

#include <Inventor/SoPath.h>

#include <QObject>
#include <QUndoStack>
#include <memory>

#include "scenegraph/SceneCompiler.h"
#include "scenegraph/SceneFile.h"

namespace haptiv {

/// The scene that is being edited: owns the graph, its undo stack and its compilation. Only undo commands change
/// the graph; whoever wants a change pushes one. Thread: GUI.
class SceneDocument : public QObject {
  Q_OBJECT
 public:
  explicit SceneDocument(QObject* parent = nullptr);
  ~SceneDocument() override;

  /// Replaces the document by a file. False: the file has errors; the diagnostics say which, the old scene stays.
  bool open(const QString& path);
  /// Replaces the document by an empty scene with a tool and a device.
  void createNew();
  /// Throws std::runtime_error that says why the file could not be written.
  void save(const QString& path);

  QString path() const;
  bool isModified() const;
  SoSeparator* root() const;
  /// The scene as text, as save would write it.
  std::string text() const;
  QUndoStack& undoStack();

  /// Of the last compilation; its scene is the last valid one, which stays in force while there are errors.
  const CompiledScene& compiled() const;
  /// Of opening and compiling, together.
  const Diagnostics& diagnostics() const;

  /// The selected shape, from the root to the shape node; null: none.
  const SoPath* selection() const;
  void select(const SoPath* path);

 signals:
  /// The graph was replaced (open, createNew): forget every node of the old one.
  void sceneReplaced();
  /// The graph was changed by a command; at most once per turn of the event loop.
  void sceneChanged();
  /// A new compilation is there; at most once per turn of the event loop, after sceneChanged.
  void sceneCompiled();
  void selectionChanged();
  void modifiedChanged(bool modified);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
