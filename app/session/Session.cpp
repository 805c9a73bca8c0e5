#include "app/session/Session.h"

#include <algorithm>

#include "app/session/SessionSeat.h"
#include "app/session/choices/SceneResolution.h"
#include "app/session/hands/LiveHand.h"
#include "app/session/recording/SessionRecorder.h"
#include "app/session/recording/UtcTime.h"
#include "device/HostButtons.h"
#include "haptics/scene/DeviceFrames.h"

namespace haptiv {
namespace {

std::unique_ptr<HandSource> handFor(const SessionSetup& setup, const std::shared_ptr<LiveHand::Seam>& seam) {
  if (setup.liveHand) return std::make_unique<LiveHand>(seam);
  return scriptedHand(setup);
}

std::unique_ptr<HapticDevice> deviceFor(const SessionSetup& setup, const std::shared_ptr<LiveHand::Seam>& seam) {
  if (setup.device) return setup.device();
  return simulatedDevice(setup, handFor(setup, seam));
}

bool samePlacement(const DevicePlacement& a, const DevicePlacement& b) {
  return a.description == b.description && a.position == b.position && a.rotation == b.rotation && a.scale == b.scale;
}

}  // namespace

struct Session::Parts {
  explicit Parts(const SessionSetup& setup)
      : scene(setup.scene),
        text(setup.sceneText),
        description(setup.description),
        device(deviceFor(setup, hand)),
        buttons(dynamic_cast<HostButtons*>(device.get())),
        seams(setup.rate),
        loop(*device, setup.description, {setup.rate, setup.spin}, seams) {
    seams.scene.write(scene);
    moveHand();
    scheduling = loop.start();
    SessionHeader header = headerOf(setup);
    header.startUtc = utcNow();
    header.scheduling = scheduling.explanation;
    std::unique_ptr<SessionLogWriter> writer;
    if (setup.log) {
      writer = std::make_unique<SessionLogWriter>(*setup.log, header);
      writer->addScene(*scene, setup.sceneText.get());
    }
    recorder = std::make_unique<SessionRecorder>(seams.log, std::move(writer), flightRecorder(setup, header));
  }

  void moveHand() {
    HandTarget target;
    if (wanted) target = {true, placeInBase(scene->device, *wanted)};
    if (wanted && wantedRotation) target.orientation = scene->device.rotation.transpose() * *wantedRotation;
    target.inputs = static_cast<std::uint16_t>(pressed | (wanted ? kInputDeadMan : 0));
    hand->write(target);
    if (buttons != nullptr) buttons->press(pressed);
  }

  void publishNewest() {
    recorder->addScene(scene, text);
    seams.scene.write(scene);
  }

  std::shared_ptr<const HapticScene> scene;  // newest that was published
  SharedText text;                           // its own
  DeviceDescription description;
  std::optional<Vector3> wanted;          // p_WH of the live hand
  std::optional<Matrix3> wantedRotation;  // R_WH of the same
  std::uint16_t pressed = 0;              // by the live operator
  std::shared_ptr<LiveHand::Seam> hand = std::make_shared<LiveHand::Seam>();
  std::unique_ptr<HapticDevice> device;
  HostButtons* buttons;  // the same device's, where it has some; else null
  ServoSeams seams;
  ServoLoop loop;
  Scheduling scheduling;
  std::unique_ptr<SessionRecorder> recorder;
};

Session::Session(SessionSetup setup) {
  expectUsable(setup);
  parts_ = std::make_unique<Parts>(setup);
}

Session::~Session() {
  try {
    stop();
  } catch (const std::exception&) {  // whoever wants to know calls stop
  }
}

std::shared_ptr<const HapticScene> Session::publish(std::shared_ptr<const HapticScene> scene, SharedText text) {
  expectFeelable(*scene);
  const HapticScene& felt = *parts_->scene;
  const bool sameSeat = samePlacement(scene->device, felt.device) && scene->tool.home == felt.tool.home;
  const bool sameDriving = scene->resolution == felt.resolution && scene->control == felt.control;
  if (!sameSeat || !sameDriving || scene->version <= felt.version) {
    HapticScene taken = *scene;
    taken.version = std::max(scene->version, felt.version + 1);
    taken.device = felt.device;
    taken.tool.home = felt.tool.home;
    taken.resolution = felt.resolution;
    taken.control = felt.control;
    scene = std::make_shared<const HapticScene>(std::move(taken));
  }
  parts_->scene = scene;
  parts_->text = std::move(text);
  parts_->publishNewest();
  return scene;
}

std::size_t Session::shapesToLog() const {
  return parts_->recorder->shapesToLog();
}

void Session::chooseResolution(const ResolutionChoice& choice) {
  expectResolvable(choice, parts_->description);
  if (resolutionOf(*parts_->scene, parts_->description) == choice) return;
  HapticScene chosen = *parts_->scene;
  ++chosen.version;
  chosen.resolution = choice;
  parts_->scene = std::make_shared<const HapticScene>(std::move(chosen));
  parts_->publishNewest();
}

void Session::moveHand(const std::optional<Vector3>& p_WH, const std::optional<Matrix3>& R_WH) {
  parts_->wanted = p_WH;
  parts_->wantedRotation = R_WH;
  parts_->moveHand();
}

void Session::press(std::uint16_t inputs) {
  parts_->pressed = inputs;
  parts_->moveHand();
}

bool Session::newest(TickRecord& record) {
  if (!parts_->seams.display.update()) return false;
  record = parts_->seams.display.read();
  return true;
}

const Scheduling& Session::scheduling() const {
  return parts_->scheduling;
}

SessionTiming Session::timing() const {
  return {parts_->seams.wakeUps.distribution(), parts_->seams.ticks.distribution(), parts_->loop.processorShare()};
}

std::string Session::logTrouble() const {
  return parts_->recorder->trouble();
}

SessionSummary Session::stop() {
  std::exception_ptr deviceTrouble;
  try {
    parts_->loop.stop();
  } catch (...) {  // the log is to be closed all the same
    deviceTrouble = std::current_exception();
  }
  SessionSummary summary = parts_->recorder->stop();
  if (deviceTrouble) std::rethrow_exception(deviceTrouble);
  return summary;
}

}  // namespace haptiv
