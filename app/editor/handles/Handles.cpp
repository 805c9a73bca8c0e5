#include "app/editor/handles/Handles.h"

#include <Inventor/SbLine.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/events/SoEvent.h>
#include <Inventor/manips/SoHandleBoxManip.h>
#include <Inventor/nodes/SoSeparator.h>

#include <QTimer>
#include <cmath>

#include "app/editor/edits/Edits.h"
#include "app/editor/handles/HandleLook.h"
#include "app/editor/handles/Snap.h"

namespace haptiv {
namespace {

constexpr double kAlongGaze = 0.999;  // cosine: nobody sees a side move that way
constexpr double kMinLean = 1e-3;     // sine squared between pull and gaze

void write(SoTransform& node, const TransformValue& value) {
  node.translation = value.translation;
  node.rotation = value.rotation;
  node.scaleFactor = value.scaleFactor;
}

}  // namespace

Handles::Handles(SceneDocument& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document, &SceneDocument::handlesInTheWay, this, [this] {
    detach();
    attachSoon();
  });
  connect(&document, &SceneDocument::selectionChanged, this, &Handles::attachSoon);
  connect(&document, &SceneDocument::sceneChanged, this, &Handles::attachSoon);
}

Handles::~Handles() {
  detach();
}

void Handles::setEnabled(bool enabled) {
  isEnabled_ = enabled;
  if (enabled) return attachSoon();
  if (isToCommit_) commit();
  detach();
}

void Handles::attachSoon() {
  if (isAttachPending_) return;
  isAttachPending_ = true;
  QTimer::singleShot(0, this, [this] {
    isAttachPending_ = false;
    attach();
  });
}

void Handles::attach() {
  if (manip_ || !isEnabled_) return;
  const SoPath* path = document_.selection();
  const auto frame = path ? ShapeFrame::of(*path) : std::nullopt;
  if (!frame) return;

  manip_ = NodeRef<SoHandleBoxManip>(new SoHandleBoxManip);
  parent_ = NodeRef<SoGroup>(frame->parent());
  if (SoTransform* transform = frame->ownTransform()) {
    write(*manip_.get(), TransformValue::of(*transform));
    manip_->scaleOrientation = transform->scaleOrientation;
    manip_->center = transform->center;
    index_ = frame->transformIndex();
    original_ = NodeRef<SoNode>(transform);
    parent_->replaceChild(index_, manip_.get());
  } else {
    index_ = frame->shapeIndex();
    original_ = NodeRef<SoNode>(path->getTail());
    NodeRef<SoSeparator> wrapper(new SoSeparator);
    wrapper->addChild(manip_.get());
    wrapper->addChild(original_.get());
    parent_->replaceChild(index_, wrapper.get());
  }
  SoDragger* dragger = manip_->getDragger();
  dressHandles(*dragger, frame->size() / 2);
  dragger->addStartCallback([](void* self, SoDragger*) { static_cast<Handles*>(self)->beginDrag(); }, this);
  dragger->addMotionCallback([](void* self, SoDragger*) { static_cast<Handles*>(self)->drag(); }, this);
  dragger->addFinishCallback([](void* self, SoDragger*) { static_cast<Handles*>(self)->endDrag(); }, this);
}

void Handles::detach() {
  if (!manip_) return;
  // The value that the drag has reached goes with the manip: only a command may keep it.
  parent_->replaceChild(index_, original_.get());
  if (isDragging_ || isToCommit_) document_.noteChange();
  if (isDragging_) {
    abandoned_ = manip_;
    isDragging_ = false;
    emit draggingChanged(false);
  }
  isToCommit_ = false;
  start_.reset();
  manip_ = {};
  parent_ = {};
  original_ = {};
}

void Handles::beginDrag() {
  const SoPath* path = document_.selection();
  start_ = manip_ && path ? ShapeFrame::of(*path) : std::nullopt;
  if (!start_) return;
  SoDragger* dragger = manip_->getDragger();
  const SbVec3f point = dragger->getWorldStartingPoint();
  grip_ = {point[0], point[1], point[2]};
  held_.reset();
  isDragging_ = true;
  emit draggingChanged(true);
}

Sides Handles::seenOf(Sides sides) const {
  const SbVec3f gaze = manip_->getDragger()->getViewVolume().getProjectionDirection();
  const Matrix3 directions = start_->directions();
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 own = directions.col(axis);
    if (std::abs(own.dot(Vector3(gaze[0], gaze[1], gaze[2]))) > kAlongGaze) sides[axis] = 0;
  }
  return sides;
}

std::optional<Vector3> Handles::pull() const {
  SoDragger* dragger = manip_->getDragger();
  const SbVec2f mouse = dragger->getEvent()->getNormalizedPosition(dragger->getViewportRegion());
  SbLine ray;
  dragger->getViewVolume().projectPointToLine(mouse, ray);
  const Vector3 direction = pullDirection(*start_, *held_);
  const Vector3 gaze(ray.getDirection()[0], ray.getDirection()[1], ray.getDirection()[2]);
  const Vector3 eye(ray.getPosition()[0], ray.getPosition()[1], ray.getPosition()[2]);
  const double slant = direction.dot(gaze);
  const double lean = 1 - slant * slant;
  if (lean < kMinLean) return std::nullopt;
  // the point of the line through the grip that is nearest to the ray under the mouse
  const Vector3 offset = eye - grip_;
  return Vector3(direction * ((offset.dot(direction) - slant * offset.dot(gaze)) / lean));
}

void Handles::drag() {
  if (!isDragging_ || isCorrecting_) return;
  ShapeFrame frame = *start_;
  frame.setValue(TransformValue::of(*manip_.get()));
  if (!held_) {
    const Sides sides = heldSides(*start_, frame, grip_);
    if (!sides.isZero()) held_ = seenOf(sides);
  }
  if (held_) {
    frame = *start_;
    const auto way = held_->isZero() ? std::nullopt : pull();
    if (way) stretch(frame, *held_, *way, toGrid_);
  } else if (toGrid_) {
    snapMove(*start_, frame);
  }
  isCorrecting_ = true;
  write(*manip_.get(), frame.value());
  isCorrecting_ = false;
  document_.noteChange();
}

void Handles::endDrag() {
  if (!isDragging_) return;
  isDragging_ = false;
  isToCommit_ = true;
  // Coin is in the midst of handing the event to the dragger: it can leave the graph only afterwards.
  QTimer::singleShot(0, this, &Handles::commit);
  emit draggingChanged(false);
}

void Handles::commit() {
  if (!isToCommit_ || !manip_) return;
  const TransformValue end = TransformValue::of(*manip_.get());
  const bool isResized = !(end.scaleFactor == start_->value().scaleFactor);
  detach();
  moveShape(
      document_, [&](ShapeFrame& frame) { frame.setValue(end); }, isResized ? "resizing" : "move");
}

}  // namespace haptiv

#include "moc_Handles.cpp"
