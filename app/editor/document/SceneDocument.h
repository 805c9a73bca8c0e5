#pragma once

#include <Inventor/SoPath.h>

#include <QObject>
#include <QUndoStack>
#include <memory>

#include "device/described/DeviceDescription.h"
#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/reading/SceneFile.h"

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

  /// Judges the scene, from now on, for sessions of so many ticks a second [Hz].
  void judgeAt(double rate);

  QString path() const;
  bool isModified() const;
  SoSeparator* root() const;
  /// The scene as text, for logs: what prototypes make, and what it includes, is written out; as Coin does it, where
  /// that cannot be done.
  std::string text() const;
  QUndoStack& undoStack();

  /// Asks whoever has put handles into the graph to take them out, so that it can be read or changed. Commands,
  /// text() and save() call it; call it before looking for nodes that a command is to change.
  void releaseHandles();
  /// The graph has changed: by a command, or by a handle that is being dragged.
  void noteChange();

  /// Of the last compilation; its scene is the last valid one, which stays in force while there are errors.
  const CompiledScene& compiled() const;
  /// The same, of the graph as it is now, with the edits of this turn of the event loop.
  const CompiledScene& compileNow();
  /// The device that the scene names; where there is none such, the one before, or the built-in one.
  const DeviceDescription& device() const;
  /// Of opening, compiling and judging, together.
  const Diagnostics& diagnostics() const;

  /// The selected shape, from the root to the shape node; null: none.
  const SoPath* selection() const;
  void select(const SoPath* path);

 signals:
  /// The graph was replaced (open, createNew): forget every node of the old one.
  void sceneReplaced();
  /// Handles must be out of the graph when this returns; they may come back in the next turn of the event loop.
  void handlesInTheWay();
  /// A new compilation is there to be felt, before anything else is done about the change: it has not been judged, and
  /// nothing was shown of it; at most once per turn of the event loop.
  void sceneReady();
  /// The graph was changed, by a command or under a handle; at most once per turn of the event loop.
  void sceneChanged();
  /// A new compilation is there; at most once per turn of the event loop, after sceneChanged.
  void sceneCompiled();
  /// A long compilation is going on, within a call: the event loop does not turn.
  void compiling(int shapes, int triangles);
  /// Compiling or opening has found something new; after sceneCompiled.
  void diagnosticsChanged();
  void selectionChanged();
  void modifiedChanged(bool modified);

 private:
  void replaceBy(SceneFile file);
  void announceSoon();
  void flush();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
