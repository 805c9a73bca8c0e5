#include "app/plots/samples/TimeWindow.h"

#include <algorithm>

namespace haptiv {

namespace {

constexpr double kNarrowest = 0.01;  // what zooming ends at [s]

}  // namespace

double TimeWindow::bounded(double time) const {
  return std::clamp(time, extentFrom_, extentTo_);
}

void TimeWindow::setExtent(double from, double to) {
  extentFrom_ = from;
  extentTo_ = std::max(to, from + kNarrowest);
  zoomed_ ? show(from_, to_) : showAll();
}

void TimeWindow::show(double from, double to) {
  const double whole = extentTo_ - extentFrom_;
  const double span = std::clamp(to - from, std::min(kNarrowest, whole), whole);
  from_ = std::clamp(from, extentFrom_, extentTo_ - span);
  to_ = from_ + span;
  zoomed_ = span < whole;
}

void TimeWindow::showAll() {
  show(extentFrom_, extentTo_);
}

void TimeWindow::zoom(double factor, double about) {
  const double share = (about - from_) / (to_ - from_);
  const double span = std::max((to_ - from_) * factor, kNarrowest);
  show(about - share * span, about + (1 - share) * span);
}

}  // namespace haptiv
