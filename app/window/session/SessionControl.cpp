#include "app/window/session/SessionControl.h"

#include <QTimer>
#include <exception>

#include "app/session/UsbBoards.h"
#include "app/session/choices/SceneControl.h"
#include "app/session/choices/SceneResolution.h"
#include "app/session/hands/SpaceMouseOperator.h"
#include "app/window/session/LogFolder.h"
#include "app/window/session/ScenePublisher.h"

namespace haptiv {

struct SessionControl::Parts {
  explicit Parts(SceneDocument& document_) : document(document_), publisher(document_) {}

  SceneDocument& document;
  std::unique_ptr<Session> session;
  ScenePublisher publisher;  // to the session
  Scheduling scheduling;
  double rate = SessionSetup{}.rate;
  DeviceDescription description;
  std::optional<ResolutionChoice> resolution;
  std::optional<ControlChoice> control;
  std::string device = "sim";
  HandInput handInput;
  std::unique_ptr<SpaceMouseOperator> spaceMouse;  // while it leads a session's hand
  double heading = 0;                              // [rad]
  std::uint16_t keys = 0;                          // pressed at the keyboard
  QString logPath;
  QString toldTrouble;
  QTimer display;

  void lead(const TickRecord& newest) {
    if (!spaceMouse) return;
    const SpaceMouseHand::Wish wish = spaceMouse->wish(newest, heading);
    session->moveHand(wish.place, wish.rotation);
    session->press(keys | wish.inputs);
  }

  void open(std::unique_ptr<HapticDevice> started) {
    SessionSetup chosen = setup();
    if (started)
      chosen.device = [held = std::make_shared<std::unique_ptr<HapticDevice>>(std::move(started))] {
        return std::move(*held);
      };
    if (handInput)
      spaceMouse = std::make_unique<SpaceMouseOperator>(*handInput, chosen.description, chosen.scene->device);
    session = std::make_unique<Session>(chosen);
    publisher.follow(*session);
    scheduling = session->scheduling();
  }

  SessionSetup setup() {
    SessionSetup setup;
    setup.sceneText = publisher.takeText();
    setup.scene = withControl(withResolution(document.compiled().scene, resolution), control);
    setup.sceneName = document.path().toStdString();
    setup.description = description = loadDeviceDescription(setup.scene->device.description, setup.sceneName);
    setup.rate = rate;
    setup.liveHand = true;
    if (isBoard(device)) setup.device = boardOf(device, setup.description);
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
    if (parts_->session->newest(record)) {
      parts_->lead(record);
      emit ticked(record);
    }
    const QString trouble = QString::fromStdString(parts_->session->logTrouble());
    if (trouble != parts_->toldTrouble) emit troubled(parts_->toldTrouble = trouble);
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
void SessionControl::setRate(double rate) {
  if (!isRunning()) parts_->rate = rate;
}
const Scheduling& SessionControl::scheduling() const {
  return parts_->scheduling;
}
SessionTiming SessionControl::timing() const {
  return isRunning() ? parts_->session->timing() : SessionTiming{};
}
const DeviceDescription& SessionControl::description() const {
  return parts_->description;
}
const std::optional<ResolutionChoice>& SessionControl::resolution() const {
  return parts_->resolution;
}
const std::optional<ControlChoice>& SessionControl::control() const {
  return parts_->control;
}
void SessionControl::forgetChoices() {
  parts_->resolution.reset();
  parts_->control.reset();
}
void SessionControl::chooseControl(const ControlChoice& choice) {
  parts_->control = choice;
}

void SessionControl::chooseResolution(const ResolutionChoice& choice) {
  try {
    if (isRunning()) parts_->session->chooseResolution(choice);
    parts_->resolution = choice;
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
}

void SessionControl::chooseDevice(const QString& device) {
  parts_->device = device.toStdString();
}

void SessionControl::chooseHand(const HandInput& input) {
  parts_->handInput = input;
}

void SessionControl::setHeading(double heading) {
  parts_->heading = heading;
}

std::optional<DeviceDescription> SessionControl::descriptionNeeded() {
  const CompiledScene& compiled = parts_->document.compiled();
  if (hasErrors(compiled.diagnostics) || !compiled.scene) {
    emit failed(tr("The scene has errors; mend them first. The list of problems names them."));
    return std::nullopt;
  }
  try {
    return loadDeviceDescription(compiled.scene->device.description, parts_->document.path().toStdString());
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
    return std::nullopt;
  }
}

void SessionControl::startWith(std::unique_ptr<HapticDevice> device) {
  if (isRunning() || !descriptionNeeded()) return;
  try {
    parts_->logPath = newLogPath(parts_->document.path());
    parts_->open(std::move(device));
  } catch (const std::exception& error) {
    parts_->spaceMouse.reset();
    emit failed(QString::fromUtf8(error.what()));
    return;
  }
  parts_->toldTrouble.clear();
  parts_->display.start();
  emit started();
}

void SessionControl::stop() {
  if (!isRunning()) return;
  parts_->publisher.finish();
  parts_->display.stop();
  const SessionSummary summary = parts_->session->stop();
  parts_->session.reset();
  parts_->spaceMouse.reset();
  parts_->keys = 0;
  emit stopped(summary);
}

void SessionControl::moveHand(const std::optional<Vector3>& p_WH) {
  if (isRunning() && !parts_->spaceMouse) parts_->session->moveHand(p_WH);
}

void SessionControl::press(std::uint16_t inputs) {
  parts_->keys = inputs;
  if (isRunning()) parts_->session->press(inputs);
}

}  // namespace haptiv

#include "moc_SessionControl.cpp"
