#include "app/replay/ReplayBar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QShortcut>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <array>

#include "app/plots/TickPlots.h"
#include "app/replay/CurveLoader.h"
#include "app/replay/LogStateLabel.h"
#include "app/replay/TimeSlider.h"

namespace haptiv {

namespace {

constexpr std::array kSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0};
constexpr double kShiftStep = 0.01;         // [s]
constexpr int kRefineAfter = 150;           // [ms] without zooming
constexpr double kShareBeforeCursor = 0.1;  // of a zoomed plot that follows the cursor

QString seconds(double time) {
  return QString::number(time, 'f', 3) + " s";
}

}  // namespace

struct ReplayBar::Parts {
  QPointer<ReplayPlayer> player;
  QToolButton* playButton = nullptr;
  QComboBox* speedBox = nullptr;
  TimeSlider* timeSlider = nullptr;
  QLabel* timeLabel = nullptr;
  QLabel* tickLabel = nullptr;
  LogStateLabel* stateLabel = nullptr;
  SignalPlot* force = nullptr;
  SignalPlot* position = nullptr;
  SignalPlot* energy = nullptr;
  CurveLoader loader;
  QTimer refineTimer;
  QMetaObject::Connection failures;

  std::array<SignalPlot*, 3> plots() const { return {force, position, energy}; }
};

ReplayBar::ReplayBar(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  setFocusPolicy(Qt::StrongFocus);
  p.force = makeForcePlot(this);
  p.position = makePositionPlot(this);
  p.energy = makeEnergyPlot(this);
  buildControls();
  addKeys();
  for (SignalPlot* plot : p.plots()) {
    plot->setFocusPolicy(Qt::ClickFocus);
    plot->setEmptyText(tr("Open a session log to replay it"));
    connect(plot, &SignalPlot::timePicked, this, [this](double time) {
      if (parts_->player) parts_->player->seek(time);
    });
    connect(plot, &SignalPlot::timeRangeChanged, this, &ReplayBar::shareRange);
  }
  connect(&p.loader, &CurveLoader::progressed, this, &ReplayBar::showCurves);
  connect(&p.loader, &CurveLoader::failed, p.stateLabel, &LogStateLabel::showFailure);
  p.refineTimer.setSingleShot(true);
  p.refineTimer.setInterval(kRefineAfter);
  connect(&p.refineTimer, &QTimer::timeout, this, [this] {
    const auto [from, to] = parts_->force->timeRange();
    parts_->loader.refine(from, to);
  });
  setPlayer(nullptr);
}

ReplayBar::~ReplayBar() = default;

void ReplayBar::buildControls() {
  Parts& p = *parts_;
  p.playButton = new QToolButton;
  p.playButton->setObjectName("playButton");
  p.playButton->setAutoRaise(true);
  p.playButton->setIconSize({20, 20});
  p.speedBox = new QComboBox;
  p.speedBox->setObjectName("speedBox");
  p.speedBox->setToolTip(tr("Speed of the replay"));
  for (const double speed : kSpeeds) p.speedBox->addItem(QString::number(speed) + "x", speed);
  p.timeSlider = new TimeSlider;
  p.timeSlider->setObjectName("timeSlider");
  p.timeLabel = new QLabel;
  p.timeLabel->setObjectName("timeLabel");
  p.tickLabel = new QLabel;
  p.tickLabel->setObjectName("tickLabel");
  p.tickLabel->setStyleSheet("color: #555b61");
  p.stateLabel = new LogStateLabel;
  p.stateLabel->setObjectName("stateLabel");
  for (QLabel* label : {p.timeLabel, p.tickLabel}) label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

  auto* controls = new QHBoxLayout;
  controls->setContentsMargins(6, 2, 8, 0);
  controls->setSpacing(8);
  controls->addWidget(p.playButton);
  controls->addWidget(p.speedBox);
  controls->addWidget(p.timeSlider, 1);
  for (QLabel* label : {p.timeLabel, p.tickLabel, static_cast<QLabel*>(p.stateLabel)}) controls->addWidget(label);
  auto* plots = new QHBoxLayout;
  for (SignalPlot* plot : p.plots()) plots->addWidget(plot, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(controls);
  layout->addLayout(plots, 1);

  connect(p.playButton, &QToolButton::clicked, this, [this] {
    if (ReplayPlayer* player = parts_->player) player->isPlaying() ? player->pause() : player->play();
  });
  connect(p.speedBox, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) {
    if (parts_->player) parts_->player->setSpeed(parts_->speedBox->itemData(index).toDouble());
  });
  connect(p.timeSlider, &TimeSlider::timePicked, this, [this](double time) {
    if (parts_->player) parts_->player->seek(time);
  });
}

/// Shortcuts rather than key events: they work whichever of the bar's widgets has the focus.
void ReplayBar::addKeys() {
  const auto key = [this](const QKeySequence& keys, auto act) {
    auto* shortcut = new QShortcut(keys, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, [this, act] {
      if (parts_->player) act(*parts_->player);
    });
    return shortcut;
  };
  key(Qt::Key_Space, [this](ReplayPlayer&) { parts_->playButton->click(); })->setAutoRepeat(false);
  key(Qt::Key_Left, [](ReplayPlayer& player) { player.step(-1); });
  key(Qt::Key_Right, [](ReplayPlayer& player) { player.step(1); });
  key(QKeySequence("Shift+Left"), [](ReplayPlayer& player) { player.seek(player.time() - kShiftStep); });
  key(QKeySequence("Shift+Right"), [](ReplayPlayer& player) { player.seek(player.time() + kShiftStep); });
  key(Qt::Key_Home, [](ReplayPlayer& player) { player.seek(0); });
  key(Qt::Key_End, [](ReplayPlayer& player) { player.seek(player.duration()); });
}

void ReplayBar::setPlayer(ReplayPlayer* player) {
  Parts& p = *parts_;
  disconnect(p.failures);
  if (p.player) p.player->disconnect(this);
  p.refineTimer.stop();
  p.loader.stop();
  p.player = player;
  for (SignalPlot* plot : p.plots()) plot->clear();
  const bool any = player && player->log().tickCount() > 0;
  for (QWidget* each : std::initializer_list<QWidget*>{p.playButton, p.speedBox, p.timeSlider}) each->setEnabled(any);
  p.timeSlider->setDuration(player ? player->duration() : 0);
  if (player) connectPlayer();
  p.stateLabel->showLog(player ? &player->log() : nullptr);
  reserveWidths();
  showPlaying();
  showTime();
}

void ReplayBar::connectPlayer() {
  Parts& p = *parts_;
  connect(p.player, &ReplayPlayer::timeChanged, this, &ReplayBar::showTime);
  connect(p.player, &ReplayPlayer::playingChanged, this, &ReplayBar::showPlaying);
  connect(p.player, &ReplayPlayer::speedChanged, this, &ReplayBar::showPlaying);
  p.failures = connect(p.player, &ReplayPlayer::failed, p.stateLabel, &LogStateLabel::showFailure);
  connect(p.player, &QObject::destroyed, this, [this] { setPlayer(nullptr); });
  if (p.player->log().tickCount() == 0) return;
  for (SignalPlot* plot : p.plots()) plot->setExtent(0, p.player->duration());
  p.loader.start(p.player->log());
}

void ReplayBar::showTime() {
  Parts& p = *parts_;
  if (!p.player) {
    p.timeLabel->clear();
    p.tickLabel->clear();
    return;
  }
  const double time = p.player->time();
  const QString whole = seconds(p.player->duration());
  p.timeSlider->setTime(time);
  p.timeLabel->setText(seconds(time) + " / " + whole);
  p.tickLabel->setText(tr("tick %1").arg(p.player->record().tick));
  keepCursorInSight(time);
  for (SignalPlot* plot : p.plots()) plot->setCursor(time);
}

void ReplayBar::showPlaying() {
  Parts& p = *parts_;
  const bool playing = p.player && p.player->isPlaying();
  p.playButton->setIcon(style()->standardIcon(playing ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
  p.playButton->setToolTip(playing ? tr("Pause (space)") : tr("Play (space)"));
  const QSignalBlocker quiet(p.speedBox);
  p.speedBox->setCurrentIndex(p.speedBox->findData(p.player ? p.player->speed() : 1.0));
}

/// The numbers must not push the slider about while they run.
void ReplayBar::reserveWidths() {
  Parts& p = *parts_;
  const QFontMetrics metrics(font());
  const QString whole = p.player ? seconds(p.player->duration()) : QString();
  p.timeLabel->setMinimumWidth(p.player ? metrics.horizontalAdvance(whole + " / " + whole) + 4 : 0);
  const QString ticks = p.player ? tr("tick %1").arg(p.player->log().tickCount()) : QString();
  p.tickLabel->setMinimumWidth(p.player ? metrics.horizontalAdvance(ticks) + 4 : 0);
}

void ReplayBar::showCurves() {
  Parts& p = *parts_;
  const Curves force = p.loader.force();
  const Curves position = p.loader.position();
  const Curves energy = p.loader.energy();
  p.force->setCurves(force.times, force.samples);
  p.position->setCurves(position.times, position.samples);
  p.energy->setCurves(energy.times, energy.samples);
}

void ReplayBar::shareRange(double from, double to) {
  for (SignalPlot* plot : parts_->plots()) plot->setTimeRange(from, to);
  parts_->refineTimer.start();
}

/// A zoomed plot turns its page where the cursor leaves it.
void ReplayBar::keepCursorInSight(double time) {
  const auto [from, to] = parts_->force->timeRange();
  if (time >= from && time <= to) return;
  const double start = time - kShareBeforeCursor * (to - from);
  shareRange(start, start + (to - from));
}

}  // namespace haptiv
