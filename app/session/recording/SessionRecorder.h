#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/session/log/writing/SessionLogWriter.h"
#include "app/session/recording/FlightRecorder.h"
#include "app/session/recording/SessionSummary.h"
#include "app/session/recording/SharedText.h"
#include "haptics/realtime/RecordRing.h"

namespace haptiv {

/// The log writer's thread: drains the servo's ring into the summary, the flight recorder and, where there is one, the
/// log.
///
/// Trouble with the log is kept as text; it stops the log, never the servo, the summary or the flight recorder.
/// Construct, call and destroy on the thread that owns the session.
class SessionRecorder {
 public:
  /// @param writer   null: nothing is logged
  /// @param flights  null: faults are not kept
  SessionRecorder(RecordRing<TickRecord>& ring, std::unique_ptr<SessionLogWriter> writer,
                  std::unique_ptr<FlightRecorder> flights = nullptr);
  ~SessionRecorder();
  SessionRecorder(const SessionRecorder&) = delete;
  SessionRecorder& operator=(const SessionRecorder&) = delete;

  /// To be called before the servo gets the scene, so that no tick is logged before the scene it felt.
  void addScene(std::shared_ptr<const HapticScene> scene, SharedText text);
  /// Shapes of scenes that were added and are not yet written.
  std::size_t shapesToLog() const;
  std::string trouble() const;
  /// Takes what is left in the ring and ends the log; the servo must have stopped. Safe to call twice.
  SessionSummary stop();

 private:
  struct NewScene {
    std::shared_ptr<const HapticScene> scene;
    SharedText text;
  };

  void run();
  void drain();
  void noteWritten(const std::vector<NewScene>& scenes);
  void recordFlight(const TickRecord& record);
  void endLog();
  void tell(const std::string& trouble);
  /// Runs `step` on the writer; what it throws ends the log and becomes the trouble.
  template <typename Step>
  void withLog(Step&& step);

  RecordRing<TickRecord>& ring_;
  std::unique_ptr<SessionLogWriter> writer_;
  std::unique_ptr<FlightRecorder> flights_;
  std::vector<TickRecord> block_;
  SessionSummary summary_;

  mutable std::mutex mutex_;  // for all below
  std::condition_variable wake_;
  bool stopping_ = false;
  std::string trouble_;
  std::vector<NewScene> newScenes_;
  std::size_t shapesToLog_ = 0;  ///< of the new scenes, and of those that are being written
  std::thread thread_;
};

}  // namespace haptiv
