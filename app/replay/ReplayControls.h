#pragma once

#include <QPointer>
#include <QWidget>

#include "app/replay/ReplayPlayer.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace haptiv {

class LogStateLabel;
class TimeSlider;

/// The row that leads a replay: play and pause, speed, a slider, time and tick, and in which state the log is.
class ReplayControls : public QWidget {
  Q_OBJECT
 public:
  explicit ReplayControls(QWidget* parent = nullptr);

  /// Leads and shows this player (not owned); null: none, disabled.
  void setPlayer(ReplayPlayer* player);
  /// As a click on play and pause.
  void clickPlay();

 public slots:
  /// A part of the log could not be read.
  void showFailure(const QString& message);

 private:
  void build();
  void showTime();
  void showPlaying();
  void reserveWidths();

  QPointer<ReplayPlayer> player_;
  QToolButton* playButton_;
  QComboBox* speedBox_;
  TimeSlider* timeSlider_;
  QLabel* timeLabel_;
  QLabel* tickLabel_;
  LogStateLabel* stateLabel_;
};

}  // namespace haptiv
