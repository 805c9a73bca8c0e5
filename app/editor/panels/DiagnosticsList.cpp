#include "app/editor/panels/DiagnosticsList.h"

#include <Inventor/VRMLnodes/SoVRMLShape.h>

#include <QStyle>
#include <algorithm>

#include "app/editor/items/SceneItems.h"

namespace haptiv {
namespace {

QString textOf(const Diagnostic& diagnostic) {
  QString text;
  if (diagnostic.line > 0) text += QString("Line %1: ").arg(diagnostic.line);
  if (!diagnostic.node.empty()) text += QString::fromStdString(diagnostic.node) + ": ";
  return text + QString::fromStdString(diagnostic.message);
}

/// Whether the node is on the way to the item, or beside it on that way: then it may act on it. The root concerns all.
bool concerns(SoSeparator* root, const SceneItem& item, const SoNode* source) {
  if (source == root) return true;
  const SoNode* node = root;
  for (const int index : item.place) {
    const auto* group = static_cast<const SoGroup*>(node);
    for (int i = 0; i <= index; ++i) {
      if (group->getChild(i) == source) return true;
    }
    node = group->getChild(index);
  }
  return false;
}

/// Whether the node is what the item shows, or how it feels. A VRML shape keeps its geometry in a field.
bool isAbout(const SceneItem& item, const SoNode* source) {
  const auto* vrml = dynamic_cast<const SoVRMLShape*>(item.node);
  return item.node == source || item.property == source || (vrml && vrml->geometry.getValue() == source);
}

}  // namespace

DiagnosticsList::DiagnosticsList(SceneDocument& document, QWidget* parent) : QListWidget(parent), document_(document) {
  setObjectName("diagnosticsList");
  setWordWrap(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(&document, &SceneDocument::diagnosticsChanged, this, &DiagnosticsList::refresh);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { selectSource(row(item)); });
  connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { selectSource(row(item)); });
  refresh();
}

void DiagnosticsList::refresh() {
  clear();
  if (document_.diagnostics().empty()) {
    auto* none = new QListWidgetItem(style()->standardIcon(QStyle::SP_DialogApplyButton), "No problems", this);
    none->setFlags(Qt::ItemIsEnabled);
    return;
  }
  for (const Diagnostic& diagnostic : document_.diagnostics()) {
    const bool isError = diagnostic.severity == Diagnostic::Severity::error;
    const QIcon icon = style()->standardIcon(isError ? QStyle::SP_MessageBoxCritical : QStyle::SP_MessageBoxWarning);
    auto* item = new QListWidgetItem(icon, textOf(diagnostic), this);
    item->setToolTip(QString::fromStdString(toText(diagnostic)));
  }
}

void DiagnosticsList::selectSource(int row) {
  const Diagnostics& diagnostics = document_.diagnostics();
  if (row < 0 || static_cast<std::size_t>(row) >= diagnostics.size()) return;
  const SoNode* source = diagnostics[static_cast<std::size_t>(row)].source;
  if (!source) return;
  document_.releaseHandles();
  const std::vector<SceneItem> items = listScene(document_.root());
  auto found = std::find_if(items.begin(), items.end(), [&](const SceneItem& item) { return isAbout(item, source); });
  if (found == items.end()) {
    found = std::find_if(items.begin(), items.end(),
                         [&](const SceneItem& item) { return concerns(document_.root(), item, source); });
  }
  if (found == items.end()) return;
  const NodeRef<SoPath> path = pathTo(document_.root(), found->place);
  document_.select(path.get());
}

}  // namespace haptiv

#include "moc_DiagnosticsList.cpp"
