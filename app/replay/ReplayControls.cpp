#include "app/replay/ReplayControls.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <array>

#include "app/replay/LogStateLabel.h"
#include "app/replay/TimeSlider.h"

namespace haptiv {

namespace {

constexpr std::array kSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0};

QString seconds(double time) {
  return QString::number(time, 'f', 3) + " s";
}

/// A widget that tests know by its name.
template <typename Widget>
Widget* named(const char* name) {
  auto* widget = new Widget;
  widget->setObjectName(name);
  return widget;
}

}  // namespace

ReplayControls::ReplayControls(QWidget* parent)
    : QWidget(parent),
      playButton_(named<QToolButton>("playButton")),
      speedBox_(named<QComboBox>("speedBox")),
      timeSlider_(named<TimeSlider>("timeSlider")),
      timeLabel_(named<QLabel>("timeLabel")),
      tickLabel_(named<QLabel>("tickLabel")),
      stateLabel_(named<LogStateLabel>("stateLabel")) {
  build();
  connect(playButton_, &QToolButton::clicked, this, [this] {
    if (player_) player_->isPlaying() ? player_->pause() : player_->play();
  });
  connect(speedBox_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) {
    if (player_) player_->setSpeed(speedBox_->itemData(index).toDouble());
  });
  connect(timeSlider_, &TimeSlider::timePicked, this, [this](double time) {
    if (player_) player_->seek(time);
  });
}

void ReplayControls::build() {
  playButton_->setAutoRaise(true);
  playButton_->setIconSize({20, 20});
  speedBox_->setToolTip(tr("Speed of the replay"));
  for (const double speed : kSpeeds) speedBox_->addItem(QString::number(speed) + "x", speed);
  tickLabel_->setStyleSheet("color: #555b61");
  for (QLabel* label : {timeLabel_, tickLabel_}) label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 8, 0);
  row->setSpacing(8);
  row->addWidget(playButton_);
  row->addWidget(speedBox_);
  row->addWidget(timeSlider_, 1);
  for (QLabel* label : {timeLabel_, tickLabel_, static_cast<QLabel*>(stateLabel_)}) row->addWidget(label);
}

void ReplayControls::setPlayer(ReplayPlayer* player) {
  if (player_) player_->disconnect(this);
  player_ = player;
  if (player) {
    connect(player, &ReplayPlayer::timeChanged, this, &ReplayControls::showTime);
    connect(player, &ReplayPlayer::playingChanged, this, &ReplayControls::showPlaying);
    connect(player, &ReplayPlayer::speedChanged, this, &ReplayControls::showPlaying);
    connect(player, &ReplayPlayer::failed, this, &ReplayControls::showFailure);
  }
  const bool any = player && player->log().tickCount() > 0;
  for (QWidget* each : std::initializer_list<QWidget*>{playButton_, speedBox_, timeSlider_}) each->setEnabled(any);
  timeSlider_->setDuration(player ? player->duration() : 0);
  stateLabel_->showLog(player ? &player->log() : nullptr);
  reserveWidths();
  showPlaying();
  showTime();
}

void ReplayControls::clickPlay() {
  playButton_->click();
}

void ReplayControls::showFailure(const QString& message) {
  stateLabel_->showFailure(message);
}

void ReplayControls::showTime() {
  if (!player_) {
    timeLabel_->clear();
    tickLabel_->clear();
    return;
  }
  timeSlider_->setTime(player_->time());
  timeLabel_->setText(seconds(player_->time()) + " / " + seconds(player_->duration()));
  tickLabel_->setText(tr("tick %1").arg(player_->record().tick));
}

void ReplayControls::showPlaying() {
  const bool playing = player_ && player_->isPlaying();
  playButton_->setIcon(style()->standardIcon(playing ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
  playButton_->setToolTip(playing ? tr("Pause (space)") : tr("Play (space)"));
  const QSignalBlocker quiet(speedBox_);
  speedBox_->setCurrentIndex(speedBox_->findData(player_ ? player_->speed() : 1.0));
}

/// The numbers must not push the slider about while they run.
void ReplayControls::reserveWidths() {
  const QFontMetrics metrics(font());
  const QString whole = player_ ? seconds(player_->duration()) : QString();
  timeLabel_->setMinimumWidth(player_ ? metrics.horizontalAdvance(whole + " / " + whole) + 4 : 0);
  const QString ticks = player_ ? tr("tick %1").arg(player_->log().tickCount()) : QString();
  tickLabel_->setMinimumWidth(player_ ? metrics.horizontalAdvance(ticks) + 4 : 0);
}

}  // namespace haptiv

#include "moc_ReplayControls.cpp"
