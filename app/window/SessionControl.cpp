#include "app/window/SessionControl.h"

#include <QDateTime>
#include <QTimer>
#include <exception>

#include "app/session/SceneResolution.h"
#include "app/window/LogFolder.h"

namespace haptiv {

struct SessionControl::Parts {
  explicit Parts(SceneDocument& document_) : document(document_) {}

  SceneDocument& document;
  std::unique_ptr<Session> session;
  Scheduling scheduling;
  double rate = SessionSetup{}.rate;
  DeviceDescription description;
  std::optional<ResolutionChoice> resolution;
  QString logPath;
  QString toldTrouble;
  std::string text;  // of the scene as it was when the last command had been done
  QTimer display;

  SessionSetup setup() {
    SessionSetup setup;
    setup.scene = withResolution(document.compiled().scene, resolution);
    setup.sceneName = document.path().toStdString();
    setup.sceneText = text;
    setup.description = description = loadDeviceDescription(setup.scene->device.description, setup.sceneName);
    setup.rate = rate;
    setup.liveHand = true;
    setup.log = logPath.toStdString();
    return setup;
  }
};

SessionControl::SessionControl(SceneDocument& document, QObject* parent)
    : QObject(parent), parts_(std::make_unique<Parts>(document)) {
  parts_->display.setTimerType(Qt::PreciseTimer);
  parts_->display.setInterval(16);
  connect(&parts_->display, &QTimer::timeout, this, [this] {
    TickRecord record;
    if (parts_->session->newest(record)) emit ticked(record);
    const QString trouble = QString::fromStdString(parts_->session->logTrouble());
    if (trouble != parts_->toldTrouble) emit troubled(parts_->toldTrouble = trouble);
  });
  // The text is taken only where a command is complete: while a handle is dragged, many scenes share one.
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this] {
    if (isRunning()) parts_->text = parts_->document.text();
  });
  connect(&document, &SceneDocument::sceneCompiled, this, [this] {
    if (isRunning() && !hasErrors(parts_->document.compiled().diagnostics))
      parts_->session->publish(parts_->document.compiled().scene, parts_->text);
  });
}

SessionControl::~SessionControl() = default;

bool SessionControl::isRunning() const {
  return parts_->session != nullptr;
}
QString SessionControl::logPath() const {
  return parts_->logPath;
}
double SessionControl::rate() const {
  return parts_->rate;
}
const Scheduling& SessionControl::scheduling() const {
  return parts_->scheduling;
}
const DeviceDescription& SessionControl::description() const {
  return parts_->description;
}
const std::optional<ResolutionChoice>& SessionControl::resolution() const {
  return parts_->resolution;
}
void SessionControl::forgetResolution() {
  parts_->resolution.reset();
}

void SessionControl::chooseResolution(const ResolutionChoice& choice) {
  try {
    if (isRunning()) parts_->session->chooseResolution(choice);
    parts_->resolution = choice;
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
}

void SessionControl::start() {
  if (isRunning()) return;
  const CompiledScene& compiled = parts_->document.compiled();
  if (hasErrors(compiled.diagnostics) || !compiled.scene) {
    emit failed(tr("The scene has errors; mend them first. The list of problems names them."));
    return;
  }
  try {
    parts_->text = parts_->document.text();
    parts_->logPath = newLogPath(parts_->document.path());
    parts_->session = std::make_unique<Session>(parts_->setup());
    parts_->scheduling = parts_->session->scheduling();
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
    return;
  }
  parts_->toldTrouble.clear();
  parts_->display.start();
  emit started();
}

void SessionControl::stop() {
  if (!isRunning()) return;
  parts_->display.stop();
  const SessionSummary summary = parts_->session->stop();
  parts_->session.reset();
  emit stopped(summary);
}

void SessionControl::moveHand(const std::optional<Vector3>& p_WH) {
  if (isRunning()) parts_->session->moveHand(p_WH);
}

}  // namespace haptiv
