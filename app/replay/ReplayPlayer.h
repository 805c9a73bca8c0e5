#pragma once

#include <QObject>
#include <cstdint>
#include <memory>

#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// A log and a place in its time: plays, pauses, scrubs. Knows nothing of widgets or of Coin.
///
/// Times are seconds since the session's start. Where a part of the log cannot be read, playing stops and the last
/// tick that could be read stays.
class ReplayPlayer : public QObject {
  Q_OBJECT
 public:
  /// Throws std::runtime_error where the log's ends cannot be read.
  explicit ReplayPlayer(SessionLog log, QObject* parent = nullptr);
  ~ReplayPlayer() override;

  const SessionLog& log() const;
  double duration() const;  ///< time of the last tick [s]
  double time() const;      ///< [s]
  bool isPlaying() const;
  double speed() const;
  /// The tick at the cursor: the newest one at its time; a default one where the log has none.
  const TickRecord& record() const;
  /// Which of the log's ticks that is.
  std::uint64_t index() const;
  /// The scene in force at the cursor.
  const LoggedScene& scene() const;

 public slots:
  /// From the cursor on; from the start where it is at the end.
  void play();
  void pause();
  void seek(double time);  ///< bounded by the log
  /// Seeks so many of the log's ticks onwards, or back; pauses.
  void step(int ticks);
  void setSpeed(double factor);  ///< 0.1 to 10

 signals:
  /// record() and scene() are those of the new time already.
  void timeChanged(double time);
  void playingChanged(bool playing);
  void speedChanged(double factor);
  void sceneChanged();
  /// A part of the log could not be read: what, and where.
  void failed(const QString& message);

 private:
  void advance();
  void moveTo(double time);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
