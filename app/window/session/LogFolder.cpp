#include "app/window/session/LogFolder.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <stdexcept>

namespace haptiv {

QString logFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Haptiv sessions";
}

QString newLogPath(const QString& scenePath) {
  const QString folder = logFolder();
  if (!QDir().mkpath(folder)) {
    throw std::runtime_error("the folder " + folder.toStdString() +
                             " for session logs cannot be made: give write access to it");
  }
  const QString scene = scenePath.isEmpty() ? QStringLiteral("untitled") : QFileInfo(scenePath).completeBaseName();
  const QString stem = folder + "/" + scene + "-" + QDateTime::currentDateTime().toString("yyyy-MM-dd-HHmmss");
  QString path = stem + ".h5";
  for (int n = 2; QFileInfo::exists(path); ++n) path = QString("%1-%2.h5").arg(stem).arg(n);
  return path;
}

}  // namespace haptiv
