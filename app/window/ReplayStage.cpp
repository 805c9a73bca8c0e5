#include "app/window/ReplayStage.h"

#include <stdexcept>
#include <utility>

#include "scenegraph/reading/SceneFile.h"

namespace haptiv {

struct ReplayStage::Parts {
  QString path;
  SceneView& view;
  ReplayPlayer player;
  DeviceDescription description;
  SceneFile shown;
};

ReplayStage::ReplayStage(const QString& logPath, SceneView& view, QObject* parent) : QObject(parent) {
  SessionLog log(logPath.toStdString());
  if (log.tickCount() == 0) throw std::runtime_error(logPath.toStdString() + ": the log holds no ticks to replay");
  DeviceDescription description =
      parseDeviceDescription(log.header().deviceText, logPath.toStdString() + " (its device description)");
  parts_.reset(new Parts{logPath, view, ReplayPlayer(std::move(log)), std::move(description), {}});

  connect(&parts_->player, &ReplayPlayer::sceneChanged, this, [this] {
    try {
      showScene();
    } catch (const std::exception& error) {
      emit failed(QString::fromUtf8(error.what()));
    }
  });
  connect(&parts_->player, &ReplayPlayer::timeChanged, this, [this] {
    parts_->view.overlay().show(parts_->player.record());
    parts_->view.redraw();
  });
  showScene();
  view.viewAll();
}

ReplayStage::~ReplayStage() = default;

ReplayPlayer& ReplayStage::player() {
  return parts_->player;
}
QString ReplayStage::logPath() const {
  return parts_->path;
}
const DeviceDescription& ReplayStage::description() const {
  return parts_->description;
}

void ReplayStage::showScene() {
  const LoggedScene& logged = parts_->player.scene();
  if (!parts_->shown.root || parts_->shown.text != logged.text) {
    SceneFile read = readSceneText(logged.text, parts_->path.toStdString() + " (its scene)");
    if (!read.root) throw std::runtime_error(toText(read.diagnostics.front()));
    parts_->shown = std::move(read);
    parts_->view.setScene(parts_->shown.root.get(), false);
  }
  parts_->view.overlay().setUp(logged.scene, parts_->description);
  parts_->view.overlay().show(parts_->player.record());
  parts_->view.redraw();
}

}  // namespace haptiv

#include "moc_ReplayStage.cpp"
