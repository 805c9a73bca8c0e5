#pragma once

#include <QTreeWidget>
#include <array>
#include <vector>

#include "app/editor/document/SceneDocument.h"
#include "app/editor/items/SceneItems.h"

namespace haptiv {

/// What the scene holds, by kind. Its current row is the document's selection. Thread: GUI.
class SceneTree : public QTreeWidget {
  Q_OBJECT
 public:
  explicit SceneTree(SceneDocument& document, QWidget* parent = nullptr);

 private:
  void refresh();
  void showSelection();
  void selectCurrent();

  SceneDocument& document_;
  std::vector<SceneItem> items_;
  std::vector<QTreeWidgetItem*> rows_;        ///< one for each of items_
  std::array<QTreeWidgetItem*, 7> groups_{};  ///< one for each kind
  bool isShowing_ = false;
};

}  // namespace haptiv
