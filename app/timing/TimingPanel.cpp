#include "app/timing/TimingPanel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "app/timing/DurationText.h"

namespace haptiv {
namespace {

constexpr int kPause = 250;                              // [ms]
constexpr int kRates[] = {500, 1000, 2000, 4000, 8000};  // [Hz]
constexpr int kUsualRate = 1000;

/// A swatch of the outline's colour, and the figures.
QString figures(const QString& name, const QColor& colour, const TimeDistribution& times) {
  const auto text = [](std::int64_t time) { return QString::fromStdString(durationText(static_cast<double>(time))); };
  return QString(
             "<span style='color:%1'>&#9632;</span> %2: half within %3, 99 % within %4, 99.9 % within %5, longest %6")
      .arg(colour.name(), name, text(times.quantile(0.5)), text(times.quantile(0.99)), text(times.quantile(0.999)),
           text(times.longest));
}

}  // namespace

TimingPanel::TimingPanel(QWidget* parent)
    : QWidget(parent),
      chart_(new TimingChart(this)),
      rate_(new QComboBox(this)),
      wakeUps_(new QLabel(this)),
      ticks_(new QLabel(this)),
      share_(new QLabel(this)) {
  setObjectName("timingPanel");
  wakeUps_->setObjectName("timingWakeUps");
  ticks_->setObjectName("timingTicks");
  share_->setObjectName("timingShare");
  rate_->setObjectName("sessionRate");
  for (const int rate : kRates) rate_->addItem(QString::number(rate), rate);
  rate_->setCurrentText(QString::number(kUsualRate));
  connect(rate_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int row) { emit rateChosen(rate_->itemData(row).toDouble()); });
  auto* choice = new QHBoxLayout;
  choice->addWidget(new QLabel(tr("Ticks per second"), this));
  choice->addWidget(rate_);
  choice->addStretch();
  auto* column = new QVBoxLayout;
  column->addLayout(choice);
  for (QLabel* label : {wakeUps_, ticks_, share_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    column->addWidget(label);
  }
  column->addStretch();
  auto* row = new QHBoxLayout(this);  // side by side: the panel shares a low dock with the plots
  row->addWidget(chart_, 2);
  row->addLayout(column, 3);
  clear();
}

bool TimingPanel::isDue() const {
  return isVisible() && (!shown_.isValid() || shown_.elapsed() >= kPause);
}

void TimingPanel::show(const SessionTiming& timing, std::uint64_t missedTicks, double rate) {
  shown_.start();
  rate_->setEnabled(false);
  chart_->show(timing.wakeUps, timing.ticks, 1e9 / rate);
  wakeUps_->setText(figures(tr("Wakes late by"), TimingChart::wakeUpColour(), timing.wakeUps));
  ticks_->setText(figures(tr("A tick takes"), TimingChart::tickColour(), timing.ticks));
  share_->setText(tr("%1 ticks, %2 missed; the servo takes %3 % of a processor")
                      .arg(timing.ticks.total)
                      .arg(missedTicks)
                      .arg(100 * timing.processorShare, 0, 'f', 1));
}

void TimingPanel::clear() {
  shown_.invalidate();
  rate_->setEnabled(true);
  chart_->show({}, {}, 0);
  wakeUps_->setText(tr("No session runs: here stands how punctual its servo is."));
  ticks_->clear();
  share_->clear();
}

}  // namespace haptiv

#include "moc_TimingPanel.cpp"
