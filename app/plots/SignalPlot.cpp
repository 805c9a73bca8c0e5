#include "app/plots/SignalPlot.h"

#include <QEvent>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "app/plots/PlotCanvas.h"
#include "app/plots/PlotGesture.h"
#include "app/plots/PlotOverlay.h"
#include "app/plots/SignalCurve.h"
#include "app/plots/samples/CalmRange.h"
#include "app/plots/samples/Signals.h"
#include "app/plots/samples/TimeWindow.h"

namespace haptiv {

namespace {

constexpr int kLabelWidth = 60;  // of a time with room about it [pixels]

}  // namespace

struct SignalPlot::Parts {
  explicit Parts(std::size_t count) : data(count) {}

  QLabel* header = nullptr;
  QwtPlot* plot = nullptr;
  std::optional<PlotOverlay> overlay;
  std::vector<SignalCurve*> curves;
  CalmRange range;
  QTimer replotTimer;
  Signals data;
  TimeWindow window{kWindow};
  bool standing = false;
  bool extentGiven = false;
  double cursor = 0;

  void fillCurves();
};

SignalPlot::SignalPlot(const QString& title, const std::vector<QString>& names, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(names.size())) {
  Parts& p = *parts_;
  p.header = new QLabel(plotHeader(title, names), this);
  p.header->setTextFormat(Qt::RichText);
  p.header->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  p.plot = makePlot(this);
  p.plot->canvas()->installEventFilter(this);
  p.overlay.emplace(*p.plot);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 0);
  layout->setSpacing(0);
  layout->addWidget(p.header);
  layout->addWidget(p.plot, 1);

  for (std::size_t i = 0; i < names.size(); ++i) {
    auto* curve = new SignalCurve(curveColour(names[i], static_cast<int>(i)));
    curve->attach(p.plot);
    p.curves.push_back(curve);
  }

  p.replotTimer.setSingleShot(true);
  p.replotTimer.setInterval(0);
  connect(&p.replotTimer, &QTimer::timeout, this, &SignalPlot::replot);
  replot();
}

SignalPlot::~SignalPlot() = default;

QSize SignalPlot::sizeHint() const {
  return {480, 160};
}

QSize SignalPlot::minimumSizeHint() const {
  return {180, 90};
}

void SignalPlot::setMinimumSpan(double span) {
  parts_->range = CalmRange(span);
  replotSoon();
}

void SignalPlot::setEmptyText(const QString& text) {
  parts_->overlay->setNote(text);
}

void SignalPlot::append(double time, const std::vector<double>& values) {
  Parts& p = *parts_;
  if (p.standing || (!p.data.empty() && time < p.data.lastTime())) clear();
  p.data.append(time, values);
  p.data.dropBefore(time - kWindow);
  // A young session fills the window from the left.
  const double start = std::max(p.data.firstTime(), time - kWindow);
  p.window = TimeWindow(kWindow);
  p.window.setExtent(start, start + kWindow);
  replotSoon();
}

void SignalPlot::setCurves(const std::vector<double>& times, const std::vector<std::vector<double>>& samples) {
  Parts& p = *parts_;
  p.standing = true;
  p.data.set(times, samples);
  if (!p.extentGiven && !times.empty()) p.window.setExtent(times.front(), times.back());
  replotSoon();
}

void SignalPlot::setExtent(double from, double to) {
  Parts& p = *parts_;
  p.standing = true;
  p.extentGiven = true;
  p.window.setExtent(from, to);
  replotSoon();
}

void SignalPlot::setTimeRange(double from, double to) {
  parts_->window.show(from, to);
  replotSoon();
}

std::pair<double, double> SignalPlot::timeRange() const {
  return {parts_->window.from(), parts_->window.to()};
}

void SignalPlot::setCursor(double time) {
  parts_->cursor = time;
  placeCursor();
}

double SignalPlot::cursor() const {
  return parts_->cursor;
}

void SignalPlot::clear() {
  Parts& p = *parts_;
  p.data.clear();
  p.window = TimeWindow(kWindow);
  p.standing = p.extentGiven = false;
  p.cursor = 0;
  p.range.reset();
  replotSoon();
}

void SignalPlot::replotSoon() {
  if (isVisible() && !parts_->replotTimer.isActive()) parts_->replotTimer.start();
}

void SignalPlot::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  replotSoon();
}

void SignalPlot::replot() {
  Parts& p = *parts_;
  p.fillCurves();
  p.plot->setAxisMaxMajor(QwtPlot::xBottom, std::clamp(p.plot->canvas()->width() / kLabelWidth, 2, 10));
  p.plot->setAxisScale(QwtPlot::xBottom, p.window.from(), p.window.to());
  p.plot->setAxisScale(QwtPlot::yLeft, p.range.lower(), p.range.upper(), p.range.step());
  p.plot->replot();
  p.overlay->showNote(p.data.empty());
  placeCursor();
}

void SignalPlot::Parts::fillCurves() {
  const auto columns = static_cast<std::size_t>(std::max(plot->canvas()->width(), 100));
  const Signals::Drawing drawing = data.draw(window.from(), window.to(), columns);
  for (std::size_t i = 0; i < curves.size(); ++i) curves[i]->setPoints(drawing.curves[i]);
  if (drawing.any) range.fit(drawing.least, drawing.greatest);
}

void SignalPlot::placeCursor() {
  Parts& p = *parts_;
  const bool shown = p.standing && !p.data.empty() && p.cursor >= p.window.from() && p.cursor <= p.window.to();
  p.overlay->placeCursor(shown ? std::optional(p.cursor) : std::nullopt);
}

bool SignalPlot::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) replotSoon();
  return (parts_->standing && mouse(event)) || QWidget::eventFilter(watched, event);
}

bool SignalPlot::mouse(QEvent* event) {
  TimeWindow& window = parts_->window;
  const PlotGesture gesture = gestureOf(*event, *parts_->plot);
  switch (gesture.kind) {
    case PlotGesture::Kind::none:
      return false;
    case PlotGesture::Kind::pick:
      emit timePicked(window.bounded(gesture.time));
      return event->type() == QEvent::MouseMove;  // a press goes on, so that the keys come to where it was
    case PlotGesture::Kind::zoom:
      window.zoom(gesture.factor, window.bounded(gesture.time));
      break;
    case PlotGesture::Kind::showAll:
      window.showAll();
      break;
  }
  replotSoon();
  emit timeRangeChanged(window.from(), window.to());
  return true;
}

}  // namespace haptiv

#include "moc_SignalPlot.cpp"
