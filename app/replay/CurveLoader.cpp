#include "app/replay/CurveLoader.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "app/plots/TickPlots.h"

namespace haptiv {

namespace {

constexpr std::uint64_t kBuckets = 8000;     // more than a screen has columns
constexpr std::uint64_t kTicksATurn = 1000;  // a few milliseconds of reading
constexpr std::uint64_t kBlocksAShow = 20;   // blocks read between two looks at a growing curve
constexpr std::uint64_t kFinerAtLeast = 2;   // what a second reading must gain
constexpr std::size_t kForceCurves = 2;
constexpr std::size_t kPositionCurves = 3;
constexpr std::size_t kEnergyCurves = 1;

std::int64_t nanoseconds(double seconds) {
  return std::llround(std::clamp(seconds, 0.0, 9e9) * 1e9);
}

}  // namespace

CurveLoader::Pass::Pass(std::uint64_t first, std::uint64_t past)
    : next(first),
      end(past),
      bucket(std::max<std::uint64_t>(1, (past - first) / kBuckets)),
      envelope(kForceCurves + kPositionCurves + kEnergyCurves, bucket) {}

CurveLoader::CurveLoader(QObject* parent) : QObject(parent) {
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &CurveLoader::readBlock);
}

void CurveLoader::start(const SessionLog& log) {
  stop();
  reader_.emplace(log);
  overview_.emplace(0, reader_->count());
  timer_.start();
}

void CurveLoader::stop() {
  timer_.stop();
  detail_.reset();
  overview_.reset();
  reader_.reset();
}

void CurveLoader::refine(double from, double to) {
  if (!reader_ || reader_->count() == 0 || overview_->bucket == 1) return;
  try {
    const Pass finer(reader_->indexAt(nanoseconds(from)), reader_->indexAt(nanoseconds(to)) + 1);
    if (finer.next >= finer.end || finer.bucket * kFinerAtLeast > overview_->bucket) return;
    detail_.emplace(finer);
    timer_.start();
  } catch (const std::exception& error) {
    emit failed(QString::fromStdString(error.what()));
  }
}

void CurveLoader::readBlock() {
  const bool inDetail = detail_ && !detail_->done();
  Pass& pass = inDetail ? *detail_ : *overview_;
  try {
    read(pass);
  } catch (const std::exception& error) {
    pass.end = pass.next;
    emit failed(QString::fromStdString(error.what()));
  }
  if (pass.done()) pass.envelope.finish();
  if (overview_->done() && (!detail_ || detail_->done())) timer_.stop();
  const bool worthALook = !inDetail && (pass.next / kTicksATurn) % kBlocksAShow == 0;
  if (pass.done() || worthALook) emit progressed();
}

void CurveLoader::read(Pass& pass) {
  const std::uint64_t until = std::min(pass.end, pass.next + kTicksATurn);
  for (; pass.next < until; ++pass.next) {
    const TickRecord& record = reader_->at(pass.next);
    const auto force = forceSample(record);
    const auto position = positionSample(record);
    pass.envelope.add(secondsOf(record),
                      std::array{force[0], force[1], position[0], position[1], position[2], energySample(record)[0]});
  }
}

Curves CurveLoader::force() const {
  return curves(0, kForceCurves);
}

Curves CurveLoader::position() const {
  return curves(kForceCurves, kPositionCurves);
}

Curves CurveLoader::energy() const {
  return curves(kForceCurves + kPositionCurves, kEnergyCurves);
}

/// The overview, and in its midst the detail where that is complete.
Curves CurveLoader::curves(std::size_t first, std::size_t count) const {
  Curves curves;
  curves.samples.resize(count);
  if (!overview_) return curves;
  const auto take = [&](const Envelope& envelope, std::ptrdiff_t from, std::ptrdiff_t to) {
    const auto& times = envelope.times();
    curves.times.insert(curves.times.end(), times.begin() + from, times.begin() + to);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& samples = envelope.samples()[first + i];
      curves.samples[i].insert(curves.samples[i].end(), samples.begin() + from, samples.begin() + to);
    }
  };
  const auto& all = overview_->envelope.times();
  const auto whole = static_cast<std::ptrdiff_t>(all.size());
  if (!detail_ || !detail_->done() || detail_->envelope.times().empty()) {
    take(overview_->envelope, 0, whole);
    return curves;
  }
  const auto& fine = detail_->envelope.times();
  const auto before = std::lower_bound(all.begin(), all.end(), fine.front()) - all.begin();
  const auto after = std::upper_bound(all.begin() + before, all.end(), fine.back()) - all.begin();
  take(overview_->envelope, 0, before);
  take(detail_->envelope, 0, static_cast<std::ptrdiff_t>(fine.size()));
  take(overview_->envelope, after, whole);
  return curves;
}

}  // namespace haptiv

#include "moc_CurveLoader.cpp"
