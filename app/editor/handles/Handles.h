#pragma once

#include <QObject>
#include <optional>

#include "app/editor/document/SceneDocument.h"
#include "app/editor/edits/ShapeFrame.h"
#include "app/editor/handles/Snap.h"
#include "scenegraph/NodeRef.h"

class SoDragger;
class SoHandleBoxManip;

namespace haptiv {

/// The box with handles around the selected shape. While it is shown, a manip stands in the graph in place of the
/// shape's own transform; it goes before the graph is read or changed and comes back afterwards. A drag is felt and
/// drawn at once, and becomes one command at its end. Thread: GUI.
class Handles : public QObject {
  Q_OBJECT
 public:
  explicit Handles(SceneDocument& document, QObject* parent = nullptr);
  ~Handles() override;

  void setEnabled(bool enabled);
  void setSnapping(bool toGrid) { toGrid_ = toGrid; }
  bool isDragging() const { return isDragging_; }
  /// Null: no handles are shown.
  SoHandleBoxManip* manip() const { return manip_.get(); }

 signals:
  void draggingChanged(bool dragging);

 private:
  void attachSoon();
  void attach();
  void detach();
  void beginDrag();
  void drag();
  void endDrag();
  /// The way that the mouse has pulled the held sides, in W [m]; nothing: not to be told from this point of view.
  std::optional<Vector3> pull() const;
  /// The sides whose motion can be seen: from above, height stays as it is.
  Sides seenOf(Sides sides) const;
  void commit();

  SceneDocument& document_;
  bool isEnabled_ = true;
  bool toGrid_ = true;
  bool isDragging_ = false;
  bool isToCommit_ = false;  ///< a drag has ended; its command waits until Coin is done with the event
  bool isAttachPending_ = false;
  bool isCorrecting_ = false;
  std::optional<ShapeFrame> start_;
  std::optional<Sides> held_;       ///< the sides that are pulled; nothing: the shape is moved, or not yet
  Vector3 grip_ = Vector3::Zero();  ///< where the mouse took hold, in W [m]

  NodeRef<SoHandleBoxManip> manip_;
  NodeRef<SoHandleBoxManip> abandoned_;  ///< taken away in mid-drag: Coin still sends it the mouse
  NodeRef<SoGroup> parent_;
  NodeRef<SoNode> original_;  ///< what stood there: the transform, or the bare shape
  int index_ = 0;
};

}  // namespace haptiv
