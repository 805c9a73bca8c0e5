#include <Inventor/fields/SoSFString.h>
#include <Inventor/nodes/SoSeparator.h>

#include <QRegularExpression>

#include "app/editor/commands/InsertNode.h"
#include "app/editor/edits/Edits.h"
#include "app/editor/edits/Grid.h"
#include "app/editor/edits/Macro.h"
#include "app/editor/items/ShapeUnit.h"

namespace haptiv {
namespace {

constexpr double kAside = 2 * Grid::kStep;  // [m]

/// A copy of what belongs to the shape alone; of a bare shape, in a Separator of its own.
NodeRef<SoSeparator> copyOfUnit(const SoPath& path, int up) {
  NodeRef<SoNode> copy(path.getNodeFromTail(up)->copy());
  copy->setName("");
  if (up > 0) return NodeRef<SoSeparator>(static_cast<SoSeparator*>(copy.get()));
  NodeRef<SoSeparator> own(new SoSeparator);
  own->addChild(copy.get());
  return own;
}

/// "wall 4" for a copy of "wall 1".
void relabel(SoSeparator& unit, const std::vector<SceneItem>& items) {
  for (int i = 0; i < unit.getNumChildren(); ++i) {
    auto* label = dynamic_cast<SoSFString*>(unit.getChild(i)->getField("label"));
    if (!label || label->getValue().getLength() == 0) continue;
    QString stem = QString::fromUtf8(label->getValue().getString());
    stem.remove(QRegularExpression(" \\d+$"));
    label->setValue(unusedLabel(items, stem).toUtf8().constData());
  }
}

}  // namespace

bool canDuplicate(const SceneDocument& document) {
  const SoPath* path = document.selection();
  return path && ShapeFrame::of(*path);
}

void duplicateShape(SceneDocument& document) {
  document.releaseHandles();
  const std::vector<SceneItem> items = listScene(document.root());
  const SceneItem* item = findItem(items, document.selection());
  if (!item || !canDuplicate(document)) return;
  const SoPath& path = *document.selection();
  const auto up = static_cast<std::size_t>(depthOfUnit(path));
  NodeRef<SoSeparator> copy = copyOfUnit(path, static_cast<int>(up));
  relabel(*copy.get(), items);
  auto* parent = static_cast<SoGroup*>(path.getNodeFromTail(static_cast<int>(up) + 1));
  ScenePlace place = item->place;
  const int index = ++place[place.size() - 1 - up];
  if (up == 0) place.push_back(0);
  const Macro macro(document, QString("copy of %1").arg(item->name));
  document.undoStack().push(new InsertNode(document, parent, index, copy.get(), "insert"));
  document.select(pathTo(document.root(), place).get());
  moveShape(
      document, [](ShapeFrame& frame) { frame.setCentre(frame.centre() + Vector3(kAside, -kAside, 0)); }, "move");
}

}  // namespace haptiv
