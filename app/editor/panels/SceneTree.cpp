#include "app/editor/panels/SceneTree.h"

#include <QHeaderView>
#include <QPainter>
#include <QScopedValueRollback>

#include "app/editor/panels/KindNames.h"

namespace haptiv {
namespace {

QIcon swatch(const QColor& colour) {
  QPixmap pixmap(14, 14);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(colour.darker(160));
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(1.5, 1.5, 11, 11), 2, 2);
  return QIcon(pixmap);
}

}  // namespace

SceneTree::SceneTree(SceneDocument& document, QWidget* parent) : QTreeWidget(parent), document_(document) {
  setObjectName("sceneTree");
  setHeaderHidden(true);
  setUniformRowHeights(true);
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    groups_[i] = new QTreeWidgetItem(this);
    groups_[i]->setFlags(Qt::ItemIsEnabled);
    groups_[i]->setExpanded(static_cast<SceneItem::Kind>(i) != SceneItem::Kind::scenery);
  }
  connect(this, &QTreeWidget::currentItemChanged, this, &SceneTree::selectCurrent);
  connect(&document, &SceneDocument::selectionChanged, this, &SceneTree::refresh);
  connect(&document, &SceneDocument::sceneChanged, this, &SceneTree::refresh);
  connect(&document, &SceneDocument::sceneReplaced, this, &SceneTree::refresh);
  refresh();
}

void SceneTree::refresh() {
  std::vector<SceneItem> items = listScene(document_.root());
  if (items != items_ || rows_.empty()) {
    const QScopedValueRollback showing(isShowing_, true);
    items_ = std::move(items);
    rows_.clear();
    for (QTreeWidgetItem* group : groups_) qDeleteAll(group->takeChildren());
    for (const SceneItem& item : items_) {
      auto* row = new QTreeWidgetItem(groups_[static_cast<std::size_t>(item.kind)], {item.name});
      row->setToolTip(0, item.name);
      if (item.kind != SceneItem::Kind::tool && item.kind != SceneItem::Kind::device)
        row->setIcon(0, swatch(item.colour));
      rows_.push_back(row);
    }
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const int count = groups_[i]->childCount();
      groups_[i]->setText(0, QString("%1 (%2)").arg(groupName(static_cast<SceneItem::Kind>(i))).arg(count));
      groups_[i]->setHidden(count == 0 && static_cast<SceneItem::Kind>(i) == SceneItem::Kind::scenery);
    }
  }
  showSelection();
}

void SceneTree::showSelection() {
  const QScopedValueRollback showing(isShowing_, true);
  const SceneItem* selected = findItem(items_, document_.selection());
  QTreeWidgetItem* row = selected ? rows_[static_cast<std::size_t>(selected - items_.data())] : nullptr;
  if (row == currentItem()) return;
  setCurrentItem(row);
  if (row) scrollToItem(row);
}

void SceneTree::selectCurrent() {
  if (isShowing_) return;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i] != currentItem()) continue;
    const ScenePlace place = items_[i].place;
    const SoNode* node = items_[i].node;
    document_.releaseHandles();
    const NodeRef<SoPath> path = pathTo(document_.root(), place);
    if (path && path->getTail() == node) document_.select(path.get());
    return;
  }
}

}  // namespace haptiv

#include "moc_SceneTree.cpp"
