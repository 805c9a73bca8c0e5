#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/editor/document/SceneDocument.h"
#include "app/session/Session.h"
#include "app/window/operator/HandMenu.h"
#include "device/types.h"

namespace haptiv {

/// Starts, feeds and stops the session that runs on the document's scene. While it runs, every valid compilation of
/// the document is published to the servo, and the newest tick is announced at the display's pace. Thread: GUI.
class SessionControl : public QObject {
  Q_OBJECT
 public:
  explicit SessionControl(SceneDocument& document, QObject* parent = nullptr);
  ~SessionControl() override;

  bool isRunning() const;
  /// Where the running session's log goes, or the last one's went.
  QString logPath() const;
  /// Ticks per second of the running session [Hz].
  double rate() const;
  /// Of the next session [Hz].
  void setRate(double rate);
  /// How the servo thread of the running session is scheduled.
  const Scheduling& scheduling() const;
  /// Of the running session; of none, nothing was measured.
  SessionTiming timing() const;
  /// The arm of the running session, or of the last one.
  const DeviceDescription& description() const;
  /// What the user has chosen for this session and those that follow; nothing: as the device description says.
  const std::optional<ResolutionChoice>& resolution() const;
  /// How the user wants the arm driven in the sessions that follow; nothing: as the device description says.
  const std::optional<ControlChoice>& control() const;
  /// For the sessions that follow, of another arm perhaps: as the device description says.
  void forgetChoices();

  /// The description of the arm that the next session needs; nothing where the scene cannot be felt, told by `failed`.
  std::optional<DeviceDescription> descriptionNeeded();
  /// As `start`, with a device that has been started already; null: the one that was chosen is made and started here.
  void startWith(std::unique_ptr<HapticDevice> device);

 public slots:
  /// Starts a session; what stands in the way is told by `failed`.
  void start() { startWith(nullptr); }
  /// Ends it and announces the log.
  void stop();
  /// Resolves the redundancy in this way, at once where a session runs; what stands in the way is told by `failed`.
  void chooseResolution(const haptiv::ResolutionChoice& choice);
  /// Drives the arm in this way from the next session on.
  void chooseControl(const haptiv::ControlChoice& choice);
  /// The arm from the next session on: "sim", or "usb[:WHICH]", an interface board. A Falcon takes its time to start:
  /// it is given to startWith.
  void chooseDevice(const QString& device);
  /// What moves the hand from the next session on. A SpaceMouse is opened when a session starts; while it leads, the
  /// mouse does not.
  void chooseHand(const haptiv::HandInput& input);
  /// Of the one who looks at the scene, about z; 0 looks along y [rad]. To him a SpaceMouse's right is right.
  void setHeading(double heading);
  /// Where the operator's hand wants the ball, p_WH [m]; nothing: it lets go.
  void moveHand(const std::optional<haptiv::Vector3>& p_WH);
  /// What else the operator presses: OperatorInput bits.
  void press(std::uint16_t inputs);

 signals:
  void started();
  /// About 60 times a second while a session runs.
  void ticked(const haptiv::TickRecord& record);
  /// The session is over and its log is closed.
  void stopped(const haptiv::SessionSummary& summary);
  void failed(const QString& message);
  /// Something about the log has gone wrong; the session goes on.
  void troubled(const QString& message);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
