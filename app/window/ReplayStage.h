#pragma once

#include <QObject>
#include <memory>

#include "app/replay/ReplayPlayer.h"
#include "app/view/SceneView.h"

namespace haptiv {

/// Puts a session log on the view's stage: the scene that was in force, the arm, the ball and its force, all as of the
/// player's cursor. Thread: GUI.
class ReplayStage : public QObject {
  Q_OBJECT
 public:
  /// Throws std::runtime_error where the log, its scene or its device description cannot be read.
  ReplayStage(const QString& logPath, SceneView& view, QObject* parent = nullptr);
  ~ReplayStage() override;

  ReplayPlayer& player();
  QString logPath() const;
  const DeviceDescription& description() const;

 signals:
  /// A scene that the log holds further on cannot be shown; the one before stays.
  void failed(const QString& message);

 private:
  void showScene();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
