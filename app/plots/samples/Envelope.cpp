#include "app/plots/samples/Envelope.h"

#include <cmath>
#include <limits>

namespace haptiv {

Envelope::Envelope(std::size_t curves, std::size_t bucket)
    : bucket_(bucket <= 2 ? 1 : bucket), extremes_(curves), samples_(curves) {}

void Envelope::Extremes::take(double value) {
  if (!std::isfinite(value)) return;
  if (!any) {
    first = second = value;
    any = true;
    return;
  }
  const double least = std::min(first, second);
  const double greatest = std::max(first, second);
  if (value < least) {  // the newest extreme is always the second
    first = greatest;
    second = value;
  } else if (value > greatest) {
    first = least;
    second = value;
  }
}

void Envelope::add(double time, std::span<const double> values) {
  if (filled_ == 0) bucketStart_ = time;
  bucketEnd_ = time;
  for (std::size_t i = 0; i < extremes_.size(); ++i) extremes_[i].take(values[i]);
  if (++filled_ == bucket_) finish();
}

void Envelope::finish() {
  if (filled_ == 0) return;
  const bool single = filled_ == 1;
  times_.push_back(bucketStart_);
  if (!single) times_.push_back(bucketEnd_);
  for (std::size_t i = 0; i < extremes_.size(); ++i) {
    const Extremes& e = extremes_[i];
    const double gap = std::numeric_limits<double>::quiet_NaN();
    samples_[i].push_back(e.any ? e.first : gap);
    if (!single) samples_[i].push_back(e.any ? e.second : gap);
    extremes_[i] = {};
  }
  filled_ = 0;
}

}  // namespace haptiv
