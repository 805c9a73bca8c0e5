#include "app/replay/TimeSlider.h"

#include <QProxyStyle>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace haptiv {

namespace {

constexpr double kStepsASecond = 1000;
constexpr double kMostSteps = 1e9;  // the slider counts in int

class JumpingStyle : public QProxyStyle {
 public:
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
};

}  // namespace

TimeSlider::TimeSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  auto* style = new JumpingStyle;
  style->setParent(this);
  setStyle(style);
  connect(this, &QSlider::valueChanged, this, [this](int value) {
    emit timePicked(value == maximum() ? duration_ : duration_ * value / std::max(maximum(), 1));
  });
}

void TimeSlider::setDuration(double seconds) {
  const QSignalBlocker quiet(this);
  duration_ = seconds;
  setRange(0, static_cast<int>(std::clamp(std::ceil(seconds * kStepsASecond), 1.0, kMostSteps)));
  setValue(0);
}

void TimeSlider::setTime(double seconds) {
  const QSignalBlocker quiet(this);
  if (duration_ > 0) setValue(static_cast<int>(std::lround(seconds / duration_ * maximum())));
}

}  // namespace haptiv

#include "moc_TimeSlider.cpp"
