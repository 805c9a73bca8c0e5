#pragma once

#include <stdexcept>
#include <string>

#include "app/editor/panels/PropertyPanel.h"
#include "app/editor/panels/SceneTree.h"

namespace haptiv {

/// A widget of a panel by its name.
template <typename Widget = NumberField>
Widget& field(QWidget& panel, const char* name) {
  auto* widget = panel.findChild<Widget*>(name);
  if (!widget) throw std::runtime_error(std::string("the panel has no ") + name);
  return *widget;
}

/// A row of the tree; null: there is none.
inline QTreeWidgetItem* rowNamed(SceneTree& tree, const QString& name) {
  const auto rows = tree.findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
  return rows.isEmpty() ? nullptr : rows.front();
}

}  // namespace haptiv
