#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/hands/HandFile.h"
#include "app/session/recording/SessionSummary.h"
#include "app/session/recording/SharedText.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/servo/ServoLoop.h"

namespace haptiv {

/// What a session is started with.
struct SessionSetup {
  std::shared_ptr<const HapticScene> scene;
  std::string sceneName;
  SharedText sceneText;
  DeviceDescription description;
  double rate = 1000;                                ///< [Hz]
  std::chrono::nanoseconds spin = ServoPace().spin;  ///< how long before each tick the servo is awake
  std::uint64_t seed = 1;
  std::vector<HandWaypoint> hand;  ///< in W; empty: the hand lets go (or is live)
  bool liveHand = false;           ///< the hand is moved by moveHand, as by the mouse
  /// Makes the device that the session drives; none: the simulated arm. A real one has a real hand: the others are not
  /// asked then.
  std::function<std::unique_ptr<HapticDevice>()> device;
  std::optional<std::filesystem::path> log;  ///< none: nothing is recorded
  /// Where to put the last ticks before a fault (FlightRecorder); none: beside the log, or nowhere without a log.
  std::optional<std::filesystem::path> flights;
};

/// How punctual a session's servo is.
struct SessionTiming {
  TimeDistribution wakeUps;   ///< how late after its deadline the servo woke
  TimeDistribution ticks;     ///< from there until all of the tick was done, device and log included
  double processorShare = 0;  ///< of one processor that the servo's thread takes; a simulated arm's reckoning is in it
};

/// A running session: device, servo thread and log writer around one scene. Owns all of them; several can exist.
/// Construct, call and destroy on one thread (the GUI's, or main's).
class Session {
 public:
  /// Throws std::runtime_error where the log cannot be written, the device not started, or the tool's home not reached.
  explicit Session(SessionSetup setup);
  ~Session();

  /// Makes a new version of the scene felt, from the next tick on, and logs it. Returns the scene as it was taken:
  /// where the device stands and the tool's home cannot change while a session runs, how the redundancy is resolved
  /// and the arm driven stays as chosen, and a version that does not rise is replaced by one that does.
  /// Throws std::runtime_error where a number of the scene is none; what was felt before stays in force.
  std::shared_ptr<const HapticScene> publish(std::shared_ptr<const HapticScene> scene, SharedText text);
  /// Shapes of scenes that were published and are still to be logged.
  std::size_t shapesToLog() const;
  /// Resolves the redundancy in this way from the next tick on, and logs it: a new version of the same scene.
  /// Throws std::runtime_error where the arm cannot be resolved so; what was chosen before stays.
  void chooseResolution(const ResolutionChoice& choice);
  /// Where the live hand wants the ball, in W; nothing: it lets go. A hand on the handle presses its dead-man's button.
  /// @param R_WH  how it wants to hold the handle; nothing: as it stood when the hand took hold of it
  void moveHand(const std::optional<Vector3>& p_WH, const std::optional<Matrix3>& R_WH = {});
  /// What else the operator of the live hand presses: OperatorInput bits.
  void press(std::uint16_t inputs);
  /// The newest tick, for the display; true if there was a new one since the last call.
  bool newest(TickRecord& record);
  const Scheduling& scheduling() const;
  /// Since the start, until now or, after `stop`, until then.
  SessionTiming timing() const;
  /// What went wrong with the log so far (disk full, records lost); empty: nothing.
  std::string logTrouble() const;
  /// Stops the servo, closes the log. Safe to call twice.
  SessionSummary stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The same without thread and clock: as fast as the machine allows, for `seconds` of session time; same setup, same
/// bytes of data (of the whole log but HDF5's superblock, which holds the time of its making). Throws as Session does,
/// and where the disk becomes full.
SessionSummary runFast(const SessionSetup& setup, double seconds);

}  // namespace haptiv
