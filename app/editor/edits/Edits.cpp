#include "app/editor/edits/Edits.h"

#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <stdexcept>

#include "app/editor/commands/InsertNode.h"
#include "app/editor/commands/RemoveNode.h"
#include "app/editor/commands/SetField.h"
#include "app/editor/edits/Macro.h"
#include "app/editor/edits/NewShape.h"
#include "app/editor/items/ShapeUnit.h"
#include "scenegraph/solid/MakeSolid.h"
#include "scenegraph/solid/SolidModel.h"

namespace haptiv {
namespace {

SoField& fieldOf(const SoNode* node, const char* name) {
  SoField* field = node->getField(name);
  if (!field) throw std::invalid_argument("A " + keyword(*node).toStdString() + " has no field \"" + name + "\".");
  return *field;
}

QString changeText(const char* field) {
  return QString("change of %1").arg(field);
}

void pushField(SceneDocument& document, SoNode* node, const char* name, const NewValue& value, Gesture gesture) {
  SoField& field = fieldOf(node, name);
  FieldValue next = value(field);
  if (next.isSameAs(field)) return;
  document.undoStack().push(new SetField(document, node, &field, std::move(next), changeText(name), gesture));
}

SoGroup* parentOf(const SoPath& path) {
  return static_cast<SoGroup*>(path.getNodeFromTail(1));
}

/// Puts the selected shape into a Separator of its own, after this node.
void wrapShape(SceneDocument& document, SoNode* before) {
  const SoPath& path = *document.selection();
  SoGroup* parent = parentOf(path);
  const int index = path.getIndexFromTail(0);
  NodeRef<SoSeparator> wrapper(new SoSeparator);
  wrapper->addChild(before);
  wrapper->addChild(path.getTail());
  document.undoStack().push(new RemoveNode(document, parent, index, "wrap"));
  document.undoStack().push(new InsertNode(document, parent, index, wrapper.get(), "wrap"));
}

}  // namespace

void editSelectedNode(SceneDocument& document, const char* field, const NewValue& value, Gesture gesture) {
  document.releaseHandles();
  if (const SoPath* path = document.selection()) pushField(document, path->getTail(), field, value, gesture);
}

void editProperty(SceneDocument& document, const char* field, const NewValue& value, Reach reach, Gesture gesture) {
  document.releaseHandles();
  const std::vector<SceneItem> items = listScene(document.root(), Naming::none);
  const SceneItem* item = findItem(items, document.selection());
  if (!item || !item->property) return;
  auto* property = const_cast<SoNode*>(item->property);
  const Sharing sharing = sharingOf(items, *item, document.root());
  if (reach == Reach::allThatShare || sharing.shapes == sharing.inseparable) {
    pushField(document, property, field, value, gesture);
    return;
  }
  NodeRef<SoNode> copy(property->copy());
  FieldValue next = value(fieldOf(copy.get(), field));
  if (next.isSameAs(fieldOf(copy.get(), field))) return;
  next.exchangeWith(fieldOf(copy.get(), field));
  const Macro macro(document, changeText(field));
  const SoPath& path = *document.selection();
  if (!standsAlone(path)) return wrapShape(document, copy.get());
  document.undoStack().push(
      new InsertNode(document, parentOf(path), path.getIndexFromTail(0), copy.get(), changeText(field)));
}

Sharing sharingOf(const std::vector<SceneItem>& items, const SceneItem& item, SoSeparator* root) {
  Sharing sharing{0, 0};
  const auto parentAt = [&](const ScenePlace& place) {
    SoNode* node = root;
    for (std::size_t i = 0; i + 1 < place.size(); ++i) node = static_cast<SoGroup*>(node)->getChild(place[i]);
    return node;
  };
  const SoNode* parent = parentAt(item.place);
  for (const SceneItem& other : items) {
    if (other.property != item.property) continue;
    ++sharing.shapes;
    if (other.node == item.node && other.place.back() == item.place.back() && parentAt(other.place) == parent) {
      ++sharing.inseparable;
    }
  }
  return sharing;
}

void moveShape(SceneDocument& document, const std::function<void(ShapeFrame&)>& change, const QString& text,
               Gesture gesture) {
  document.releaseHandles();
  const SoPath* path = document.selection();
  auto frame = path ? ShapeFrame::of(*path) : std::nullopt;
  if (!frame) return;
  const TransformValue before = frame->value();
  change(*frame);
  const TransformValue after = frame->value();
  if (after == before) return;
  if (SoTransform* transform = frame->ownTransform()) {
    document.undoStack().push(new SetTransform(document, transform, after, text, gesture));
    return;
  }
  NodeRef<SoTransform> transform(new SoTransform);
  transform->translation = after.translation;
  transform->rotation = after.rotation;
  transform->scaleFactor = after.scaleFactor;
  const Macro macro(document, text);
  wrapShape(document, transform.get());
}

void removeShape(SceneDocument& document) {
  document.releaseHandles();
  const std::vector<SceneItem> items = listScene(document.root());
  const SceneItem* item = findItem(items, document.selection());
  if (!item || item->kind == SceneItem::Kind::tool || item->kind == SceneItem::Kind::device) return;
  const SoPath& path = *document.selection();
  const int up = depthOfUnit(path);
  auto* parent = static_cast<SoGroup*>(path.getNodeFromTail(up + 1));
  const int index = path.getIndexFromTail(up);
  document.undoStack().push(new RemoveNode(document, parent, index, QString("removal of %1").arg(item->name)));
  document.select(nullptr);
}

bool isScenery(const std::vector<SceneItem>& items) {
  const auto isShape = [](const SceneItem& item) { return item.kind == SceneItem::Kind::scenery; };
  const auto hasProperty = [](const SceneItem& item) { return item.property != nullptr; };
  return std::any_of(items.begin(), items.end(), isShape) && std::none_of(items.begin(), items.end(), hasProperty);
}

void makeSolid(SceneDocument& document) {
  document.releaseHandles();
  const std::vector<NodeRef<>> nodes = solidNodes(document.root(), document.device());
  const Macro macro(document, "making the scene solid");
  for (const NegativeSize& size : negativeSizes(document.root())) {
    FieldValue drawn = FieldValue::of<SoSFFloat>(*size.field, -size.field->getValue());
    document.undoStack().push(new SetField(document, size.node, size.field, std::move(drawn), "size"));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    document.undoStack().push(new InsertNode(document, document.root(), static_cast<int>(i), nodes[i].get(), "insert"));
  }
}

void addShape(SceneDocument& document, SceneItem::Kind kind) {
  document.releaseHandles();
  const NewShape made = newShape(document, kind);
  SoSeparator* root = document.root();
  const int index = root->getNumChildren();
  const Macro macro(document, QString("new %1").arg(made.label));
  document.undoStack().push(new InsertNode(document, root, index, made.node.get(), "insert"));
  const NodeRef<SoPath> path = pathTo(root, {index, made.node->getNumChildren() - 1});
  document.select(path.get());
  // What the scene's root says before its end may shift the new shape.
  moveShape(
      document,
      [&](ShapeFrame& frame) {
        if (!frame.centre().isApprox(made.centre, 1e-5)) frame.setCentre(made.centre);
      },
      "move");
}

}  // namespace haptiv
