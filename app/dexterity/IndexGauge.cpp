#include "app/dexterity/IndexGauge.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/dexterity/DexterityColours.h"

namespace haptiv {
namespace {

constexpr double kBarEnd = 1.5;  // normalised; a single pose can be better than the average best
constexpr int kBarHeight = 10;

QColor colourOf(double condition) {
  if (condition >= IndexGauge::kSingular) return DexterityColours::bad();
  return condition >= IndexGauge::kNear ? DexterityColours::near() : DexterityColours::good();
}

QString wordOf(double condition) {
  if (condition >= IndexGauge::kSingular) return IndexGauge::tr("singular");
  return condition >= IndexGauge::kNear ? IndexGauge::tr("near a singularity") : QString();
}

void setTextIfChanged(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

}  // namespace

/// From zero to kBarEnd, with a mark at 1.
class IndexGauge::Bar : public QWidget {
 public:
  using QWidget::QWidget;
  void show(double share, const QColor& colour) {
    if (share_ == share && colour_ == colour) return;
    share_ = share;
    colour_ = colour;
    update();
  }
  QSize sizeHint() const override { return {80, kBarHeight + 4}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const QRect track(0, 2, width(), kBarHeight);
    const auto at = [&](double share) { return static_cast<int>(std::lround(share / kBarEnd * track.width())); };
    painter.fillRect(track, DexterityColours::track());
    painter.fillRect(QRect(0, track.top(), at(std::clamp(share_, 0.0, kBarEnd)), track.height()), colour_);
    painter.fillRect(QRect(at(1), 0, 2, height()), DexterityColours::mark());
  }

 private:
  double share_ = 0;
  QColor colour_ = DexterityColours::good();
};

IndexGauge::IndexGauge(const QString& title, const QString& unit, QWidget* parent)
    : QWidget(parent),
      unit_(unit),
      warning_(new QLabel),
      share_(new QLabel),
      bar_(new Bar(this)),
      details_(new QLabel) {
  share_->setObjectName("indexLabel");
  warning_->setObjectName("singularityLabel");
  details_->setObjectName("singularValuesLabel");
  QFont bold = font();
  bold.setBold(true);
  auto* name = new QLabel(title);
  for (QLabel* label : {name, share_, warning_}) label->setFont(bold);
  share_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  details_->setStyleSheet("color: " + DexterityColours::faint().name());
  bar_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

  auto* heading = new QHBoxLayout;
  heading->addWidget(name);
  heading->addWidget(warning_, 1);
  heading->addWidget(share_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(1);
  layout->addLayout(heading);
  layout->addWidget(bar_);
  layout->addWidget(details_);
  bar_->setToolTip(
      tr("m = V/\u03ba, eqs. (12), (14): volume over condition number of the manipulability ellipsoid.\n"
         "The mark at 1 is the average, over the poses of the device description, of the best that\n"
         "self-motion reaches from there: the normalisation of eq. (15)."));
  details_->setToolTip(
      tr("\u03ba: condition number, 1 is best. \u03c3 min: the tool's velocity in its slowest direction, "
         "at joint rates of norm 1 rad/s."));
}

void IndexGauge::show(const Dexterity& dexterity, double best) {
  const double condition = dexterity.condition();
  const double share = best > 0 ? dexterity.directional() / best : 0;
  const QColor colour = colourOf(condition);
  bar_->show(share, colour);
  setTextIfChanged(share_, best > 0 ? QString::number(share, 'f', 2) : QString::fromUtf8("\u2013"));
  const QString word = wordOf(condition);
  if (warning_->text() != word) {
    warning_->setText(word);
    warning_->setStyleSheet("color: " + colour.name());
  }
  const QString shown = condition < 1000 ? QString::number(condition, 'f', 1) : QString("> 1000");
  setTextIfChanged(details_, QString::fromUtf8("\u03ba %1    \u03c3 min %2 %3")
                                 .arg(shown, QString::number(dexterity.sigma[2], 'f', 3), unit_));
}

}  // namespace haptiv
