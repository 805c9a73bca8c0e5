#include "app/replay/ReplayPlayer.h"

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <exception>

#include "app/replay/LogReader.h"

namespace haptiv {

namespace {

constexpr int kFrame = 16;  // [ms]
constexpr double kSlowest = 0.1;
constexpr double kFastest = 10;

double seconds(const TickRecord& record) {
  return static_cast<double>(record.time) * 1e-9;
}

}  // namespace

struct ReplayPlayer::Parts {
  explicit Parts(SessionLog taken) : log(std::move(taken)), reader(log) {}

  SessionLog log;
  LogReader reader;
  TickRecord record;
  std::uint64_t index = 0;
  double duration = 0;
  double time = 0;
  double speed = 1;
  LoggedScene noScene;
  const LoggedScene* scene = &noScene;

  QTimer timer;
  QElapsedTimer clock;
  double timeAtStart = 0;  ///< the cursor when the clock was started

  /// The one with this version; where a log lacks it, the newest before it.
  const LoggedScene& sceneOf(std::uint32_t version) const {
    const LoggedScene* best = log.scenes().empty() ? &noScene : &log.scenes().front();
    for (const LoggedScene& candidate : log.scenes()) {
      if (candidate.scene.version <= version) best = &candidate;
    }
    return *best;
  }
  void startClock() {
    timeAtStart = time;
    clock.start();
  }
};

ReplayPlayer::ReplayPlayer(SessionLog log, QObject* parent)
    : QObject(parent), parts_(std::make_unique<Parts>(std::move(log))) {
  Parts& p = *parts_;
  if (p.reader.count() > 0) {
    p.duration = std::max(0.0, seconds(p.reader.at(p.reader.count() - 1)));
    p.record = p.reader.at(0);
  }
  p.scene = &p.sceneOf(p.record.sceneVersion);
  p.timer.setTimerType(Qt::PreciseTimer);
  p.timer.setInterval(kFrame);
  connect(&p.timer, &QTimer::timeout, this, &ReplayPlayer::advance);
}

ReplayPlayer::~ReplayPlayer() = default;

const SessionLog& ReplayPlayer::log() const {
  return parts_->log;
}

double ReplayPlayer::duration() const {
  return parts_->duration;
}

double ReplayPlayer::time() const {
  return parts_->time;
}

bool ReplayPlayer::isPlaying() const {
  return parts_->timer.isActive();
}

double ReplayPlayer::speed() const {
  return parts_->speed;
}

const TickRecord& ReplayPlayer::record() const {
  return parts_->record;
}

std::uint64_t ReplayPlayer::index() const {
  return parts_->index;
}

const LoggedScene& ReplayPlayer::scene() const {
  return *parts_->scene;
}

void ReplayPlayer::play() {
  Parts& p = *parts_;
  if (isPlaying() || p.duration <= 0) return;
  if (p.time >= p.duration) seek(0);
  p.startClock();
  p.timer.start();
  emit playingChanged(true);
}

void ReplayPlayer::pause() {
  if (!isPlaying()) return;
  parts_->timer.stop();
  emit playingChanged(false);
}

void ReplayPlayer::advance() {
  Parts& p = *parts_;
  const double target = p.timeAtStart + static_cast<double>(p.clock.nsecsElapsed()) * 1e-9 * p.speed;
  moveTo(target);
  if (target >= p.duration) pause();
}

void ReplayPlayer::seek(double time) {
  if (std::isnan(time)) return;
  moveTo(time);
  parts_->startClock();
}

void ReplayPlayer::moveTo(double time) {
  Parts& p = *parts_;
  if (p.reader.count() == 0) return;
  time = std::clamp(time, 0.0, p.duration);
  try {
    // Rounded: the time of a tick, taken in seconds and back, is to find that tick.
    const std::uint64_t index = p.reader.indexAt(std::llround(time * 1e9));
    p.record = p.reader.at(index);
    p.index = index;
  } catch (const std::exception& error) {
    pause();
    emit failed(QString::fromStdString(error.what()));
    return;
  }
  p.time = time;
  const LoggedScene& scene = p.sceneOf(p.record.sceneVersion);
  const bool sceneIsNew = &scene != p.scene;
  p.scene = &scene;
  if (sceneIsNew) emit sceneChanged();
  emit timeChanged(time);
}

void ReplayPlayer::step(int ticks) {
  Parts& p = *parts_;
  if (p.reader.count() == 0) return;
  pause();
  const auto last = static_cast<std::int64_t>(p.reader.count()) - 1;
  const std::int64_t target = std::clamp<std::int64_t>(static_cast<std::int64_t>(p.index) + ticks, 0, last);
  try {
    seek(seconds(p.reader.at(static_cast<std::uint64_t>(target))));
  } catch (const std::exception& error) {
    emit failed(QString::fromStdString(error.what()));
  }
}

void ReplayPlayer::setSpeed(double factor) {
  Parts& p = *parts_;
  factor = std::clamp(factor, kSlowest, kFastest);
  if (factor == p.speed) return;
  if (isPlaying()) advance();
  p.startClock();
  p.speed = factor;
  emit speedChanged(factor);
}

}  // namespace haptiv

#include "moc_ReplayPlayer.cpp"
