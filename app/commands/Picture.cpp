#include "app/commands/Picture.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "app/commands/ExitCode.h"
#include "app/view/drawn/HapticOverlay.h"
#include "app/view/picture/OffscreenPicture.h"

namespace haptiv {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw CommandFailure(kCouldNot, path + ": cannot be written: " + why);
}

}  // namespace

QImage drawSession(const LoadedScene& loaded, const TickRecord& record) {
  HapticOverlay overlay;
  overlay.setUp(*loaded.compiled.scene, loaded.device);
  overlay.show(record);
  const NodeRef<SoSeparator> root(new SoSeparator);
  root->addChild(loaded.file.root.get());
  root->addChild(overlay.root());
  return drawOffscreen(root.get(), kWidth, kHeight);
}

void savePicture(const QImage& picture, const std::string& path) {
  const QString name = QString::fromStdString(path);
  const QFileInfo target(name);
  if (target.exists() && !target.isFile()) {  // a device or a pipe is written to, never replaced
    QFile special(name);
    if (!special.open(QIODevice::WriteOnly) || !picture.save(&special, "PNG") || !special.flush())
      refuse(path, special.errorString().toStdString());
    return;
  }
  QSaveFile file(name);
  file.setDirectWriteFallback(true);  // folders in which only this file may be written
  if (!file.open(QIODevice::WriteOnly) || !picture.save(&file, "PNG") || !file.commit())
    refuse(path, file.errorString().toStdString());
}

void requireWritable(const std::string& path) {
  const QFileInfo file(QString::fromStdString(path));
  const QFileInfo folder(file.absolutePath());
  if (file.isDir()) refuse(path, "this is a folder; name a file in it");
  if (!folder.isDir()) refuse(path, "there is no folder " + folder.filePath().toStdString() + "; make it first");
  if (file.exists() ? !file.isWritable() : !folder.isWritable())
    refuse(path, "permission denied; choose another folder");
}

}  // namespace haptiv
