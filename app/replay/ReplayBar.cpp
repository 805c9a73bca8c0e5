#include "app/replay/ReplayBar.h"

#include <QHBoxLayout>
#include <QPointer>
#include <QShortcut>
#include <QTimer>
#include <array>

#include "app/plots/TickPlots.h"
#include "app/replay/CurveLoader.h"
#include "app/replay/ReplayControls.h"

namespace haptiv {

namespace {

constexpr double kShiftStep = 0.01;         // [s]
constexpr int kRefineAfter = 150;           // [ms] without zooming
constexpr double kShareBeforeCursor = 0.1;  // of a zoomed plot that follows the cursor

}  // namespace

struct ReplayBar::Parts {
  QPointer<ReplayPlayer> player;
  ReplayControls* controls = nullptr;
  SignalPlot* force = nullptr;
  SignalPlot* position = nullptr;
  SignalPlot* energy = nullptr;
  CurveLoader loader;
  QTimer refineTimer;

  std::array<SignalPlot*, 3> plots() const { return {force, position, energy}; }
};

ReplayBar::ReplayBar(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  setFocusPolicy(Qt::StrongFocus);
  p.force = makeForcePlot(this);
  p.position = makePositionPlot(this);
  p.energy = makeEnergyPlot(this);
  p.controls = new ReplayControls(this);
  layOut();
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
  connect(&p.loader, &CurveLoader::failed, p.controls, &ReplayControls::showFailure);
  p.refineTimer.setSingleShot(true);
  p.refineTimer.setInterval(kRefineAfter);
  connect(&p.refineTimer, &QTimer::timeout, this, [this] {
    const auto [from, to] = parts_->force->timeRange();
    parts_->loader.refine(from, to);
  });
  setPlayer(nullptr);
}

ReplayBar::~ReplayBar() = default;

void ReplayBar::layOut() {
  Parts& p = *parts_;
  auto* plots = new QHBoxLayout;
  for (SignalPlot* plot : p.plots()) plots->addWidget(plot, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(p.controls);
  layout->addLayout(plots, 1);
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
  key(Qt::Key_Space, [this](ReplayPlayer&) { parts_->controls->clickPlay(); })->setAutoRepeat(false);
  key(Qt::Key_Left, [](ReplayPlayer& player) { player.step(-1); });
  key(Qt::Key_Right, [](ReplayPlayer& player) { player.step(1); });
  key(QKeySequence("Shift+Left"), [](ReplayPlayer& player) { player.seek(player.time() - kShiftStep); });
  key(QKeySequence("Shift+Right"), [](ReplayPlayer& player) { player.seek(player.time() + kShiftStep); });
  key(Qt::Key_Home, [](ReplayPlayer& player) { player.seek(0); });
  key(Qt::Key_End, [](ReplayPlayer& player) { player.seek(player.duration()); });
}

void ReplayBar::setPlayer(ReplayPlayer* player) {
  Parts& p = *parts_;
  if (p.player) p.player->disconnect(this);
  p.refineTimer.stop();
  p.loader.stop();
  p.player = player;
  for (SignalPlot* plot : p.plots()) plot->clear();
  p.controls->setPlayer(player);
  if (player) connectPlayer();
  showTime();
}

void ReplayBar::connectPlayer() {
  Parts& p = *parts_;
  connect(p.player, &ReplayPlayer::timeChanged, this, &ReplayBar::showTime);
  connect(p.player, &QObject::destroyed, this, [this] { setPlayer(nullptr); });
  if (p.player->log().tickCount() == 0) return;
  for (SignalPlot* plot : p.plots()) plot->setExtent(0, p.player->duration());
  p.loader.start(p.player->log());
}

void ReplayBar::showTime() {
  const Parts& p = *parts_;
  if (!p.player) return;
  keepCursorInSight(p.player->time());
  for (SignalPlot* plot : p.plots()) plot->setCursor(p.player->time());
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

#include "moc_ReplayBar.cpp"
