// The window's files: opening scenes and logs, saving, and asking before anything is lost.
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <exception>

#include "app/window/MainWindowParts.h"
#include "app/window/session/LogFolder.h"

namespace haptiv {

void MainWindow::open(const QString& sceneOrLog) {
  if (QFileInfo(sceneOrLog).suffix().toLower() == "h5") {
    enterReplay(sceneOrLog);
    return;
  }
  if (parts_->replay) enterEditing();
  if (parts_->document->open(sceneOrLog)) return;
  QStringList lines;
  for (const Diagnostic& each : parts_->document->diagnostics()) {
    if (lines.size() < 12) lines << QString::fromStdString(toText(each));
  }
  tell(tr("This scene could not be opened:\n\n%1").arg(lines.join("\n")));
}

void MainWindow::askToOpen() {
  if (!mayDiscardChanges()) return;
  const QString path = QFileDialog::getOpenFileName(this, tr("Open"), parts_->document->path(),
                                                    tr("Scenes and session logs (*.iv *.wrl *.h5);;All files (*)"));
  if (!path.isEmpty()) open(path);
}

bool MainWindow::save(bool askForName) {
  QString path = parts_->document->path();
  if (askForName || path.isEmpty()) {
    path = QFileDialog::getSaveFileName(this, tr("Save the scene"), path, tr("Scenes (*.iv)"));
    if (path.isEmpty()) return false;
    if (QFileInfo(path).suffix().isEmpty()) path += ".iv";
  }
  try {
    parts_->document->save(path);
  } catch (const std::exception& error) {
    tell(QString::fromUtf8(error.what()));
    return false;
  }
  updateTitle();
  return true;
}

bool MainWindow::mayDiscardChanges() {
  if (!parts_->document->isModified()) return true;
  const auto answer = QMessageBox::question(this, tr("Haptiv"), tr("The scene has changes that are not saved."),
                                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save) return save(false);
  return answer == QMessageBox::Discard;
}

}  // namespace haptiv
