#pragma once

#include <QObject>
#include <memory>

#include "app/session/SessionLog.h"

namespace haptiv {

/// A log and a place in its time: plays, pauses, scrubs. Knows nothing of widgets or of Coin.
class ReplayPlayer : public QObject {
  Q_OBJECT
 public:
  explicit ReplayPlayer(SessionLog log, QObject* parent = nullptr);
  ~ReplayPlayer() override;

  const SessionLog& log() const;
  double duration() const;  ///< [s]
  double time() const;      ///< [s]
  bool isPlaying() const;
  /// The tick at the cursor.
  const TickRecord& record() const;
  /// The scene in force at the cursor.
  const LoggedScene& scene() const;

 public slots:
  void play();
  void pause();
  void seek(double time);
  void setSpeed(double factor);  ///< 0.1 to 10

 signals:
  void timeChanged(double time);
  void playingChanged(bool playing);
  void sceneChanged();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
