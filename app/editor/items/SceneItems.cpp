#include "app/editor/items/SceneItems.h"

#include <Inventor/nodes/SoGroup.h>

#include <QHash>
#include <algorithm>

#include "app/editor/items/SceneWalk.h"

namespace haptiv {
namespace {

/// Items that share a name get numbers.
void numberNames(std::vector<SceneItem>& items) {
  QHash<QString, int> uses;
  for (const SceneItem& item : items) ++uses[item.name];
  QHash<QString, int> seen;
  for (SceneItem& item : items) {
    if (uses[item.name] > 1) item.name = QString("%1 (%2)").arg(item.name).arg(++seen[item.name]);
  }
}

}  // namespace

std::vector<SceneItem> listScene(SoSeparator* root, Naming naming) {
  if (!root) return {};
  std::vector<SceneItem> items = walkScene(*root, naming);
  if (naming == Naming::full) numberNames(items);
  return items;
}

const SceneItem* findItem(const std::vector<SceneItem>& items, const SoPath* path) {
  if (!path) return nullptr;
  const ScenePlace place = placeOf(*path);
  const auto found = std::find_if(items.begin(), items.end(), [&](const SceneItem& item) {
    return item.node == path->getTail() && item.place == place;
  });
  return found == items.end() ? nullptr : &*found;
}

ScenePlace placeOf(const SoPath& path) {
  ScenePlace place;
  for (int i = 1; i < path.getLength(); ++i) place.push_back(path.getIndex(i));
  return place;
}

NodeRef<SoPath> pathTo(SoSeparator* root, const ScenePlace& place) {
  NodeRef<SoPath> path(new SoPath(root));
  SoNode* node = root;
  for (const int index : place) {
    if (!node->isOfType(SoGroup::getClassTypeId())) return {};
    auto* group = static_cast<SoGroup*>(node);
    if (index >= group->getNumChildren()) return {};
    path->append(index);
    node = group->getChild(index);
  }
  return path;
}

QString unusedLabel(const std::vector<SceneItem>& items, const QString& stem) {
  for (int number = 1;; ++number) {
    const QString label = QString("%1 %2").arg(stem).arg(number);
    const auto isTaken = [&](const SceneItem& item) { return item.label == label || item.name == label; };
    if (std::none_of(items.begin(), items.end(), isTaken)) return label;
  }
}

QString keyword(const SoNode& node) {
  return node.getTypeId().getName().getString();
}

}  // namespace haptiv
