#include "app/commands/Picture.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "app/commands/NamedFile.h"

namespace haptiv {

void savePicture(const QImage& picture, const std::string& path) {
  const QString name = QString::fromStdString(path);
  const QFileInfo target(name);
  if (target.exists() && !target.isFile()) {  // a device or a pipe is written to, never replaced
    QFile special(name);
    if (!special.open(QIODevice::WriteOnly) || !picture.save(&special, "PNG") || !special.flush())
      refuseToWrite(path, special.errorString().toStdString());
    return;
  }
  QSaveFile file(name);
  file.setDirectWriteFallback(true);  // folders in which only this file may be written
  if (!file.open(QIODevice::WriteOnly) || !picture.save(&file, "PNG") || !file.commit())
    refuseToWrite(path, file.errorString().toStdString());
}

}  // namespace haptiv
