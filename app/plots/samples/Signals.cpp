#include "app/plots/samples/Signals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plots/samples/Envelope.h"

namespace haptiv {

namespace {

constexpr std::ptrdiff_t kDropAtLeast = 4096;  // samples: dropping each one alone would move all the others each time

}  // namespace

void Signals::append(double time, const std::vector<double>& values) {
  times_.push_back(time);
  for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].push_back(values.at(i));
}

void Signals::set(const std::vector<double>& times, const std::vector<std::vector<double>>& samples) {
  const std::size_t curves = samples_.size();
  times_ = times;
  samples_ = samples;
  samples_.resize(curves);
  for (auto& curve : samples_) curve.resize(times_.size(), std::numeric_limits<double>::quiet_NaN());
}

void Signals::clear() {
  times_.clear();
  for (auto& curve : samples_) curve.clear();
}

void Signals::dropBefore(double time) {
  const auto old = std::lower_bound(times_.begin(), times_.end(), time) - times_.begin();
  if (old < kDropAtLeast) return;
  times_.erase(times_.begin(), times_.begin() + old - 1);
  for (auto& curve : samples_) curve.erase(curve.begin(), curve.begin() + old - 1);
}

Signals::Drawing Signals::draw(double from, double to, std::size_t columns) const {
  auto first = static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), from) - times_.begin());
  auto last = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), to) - times_.begin());
  if (first > 0) --first;  // the lines run on to the edges
  if (last < times_.size()) ++last;
  const std::size_t count = last - first;
  const std::size_t bucket = count > 2 * columns ? (count + columns - 1) / columns : 1;

  Drawing drawing;
  drawing.least = std::numeric_limits<double>::infinity();
  drawing.greatest = -drawing.least;
  for (const auto& curve : samples_) {
    Envelope envelope(1, bucket);
    for (std::size_t k = first; k < last; ++k) envelope.add(times_[k], {&curve[k], 1});
    envelope.finish();
    QVector<QPointF> points;
    points.reserve(static_cast<int>(envelope.times().size()));
    for (std::size_t k = 0; k < envelope.times().size(); ++k) {
      const double value = envelope.samples()[0][k];
      if (!std::isfinite(value)) continue;
      drawing.least = std::min(drawing.least, value);
      drawing.greatest = std::max(drawing.greatest, value);
      points.push_back({envelope.times()[k], value});
    }
    drawing.curves.push_back(points);
  }
  drawing.any = drawing.least <= drawing.greatest;
  return drawing;
}

}  // namespace haptiv
