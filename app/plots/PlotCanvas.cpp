#include "app/plots/PlotCanvas.h"

#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <QLocale>
#include <array>

namespace haptiv {

namespace {

const QColor kGridColour(0xe9, 0xec, 0xef);
const QColor kBorderColour(0xc8, 0xcd, 0xd2);
const QColor kLabelColour(0x55, 0x5b, 0x61);

class Seconds : public QwtScaleDraw {
 public:
  QwtText label(double value) const override { return QwtText(QLocale().toString(value, 'g', 7) + " s"); }
};

void calmAxis(QwtPlot& plot, int axis) {
  QwtScaleWidget* widget = plot.axisWidget(axis);
  QFont font = widget->font();
  font.setPointSizeF(8);
  plot.setAxisFont(axis, font);
  QPalette palette = widget->palette();
  palette.setColor(QPalette::WindowText, kBorderColour);
  palette.setColor(QPalette::Text, kLabelColour);
  widget->setPalette(palette);
  widget->setMargin(0);
  QwtScaleDraw* draw = plot.axisScaleDraw(axis);
  draw->enableComponent(QwtAbstractScaleDraw::Backbone, false);
  draw->setTickLength(QwtScaleDiv::MinorTick, 0);
  draw->setTickLength(QwtScaleDiv::MediumTick, 0);
  draw->setTickLength(QwtScaleDiv::MajorTick, 4);
  plot.setAxisMaxMinor(axis, 0);
}

}  // namespace

QwtPlot* makePlot(QWidget* parent) {
  auto* plot = new QwtPlot(parent);
  plot->setAutoReplot(false);
  auto* canvas = new QwtPlotCanvas;
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setFocusIndicator(QwtPlotCanvas::NoFocusIndicator);
  canvas->setFocusPolicy(Qt::NoFocus);  // the keys belong to what the plot stands in
  canvas->setCursor(Qt::ArrowCursor);
  plot->setCanvas(canvas);
  plot->setCanvasBackground(Qt::white);
  plot->setAxisScaleDraw(QwtPlot::xBottom, new Seconds);
  calmAxis(*plot, QwtPlot::xBottom);
  calmAxis(*plot, QwtPlot::yLeft);
  const QFontMetrics metrics(plot->axisFont(QwtPlot::yLeft));
  plot->axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(metrics.horizontalAdvance("-0.000") + 8);
  const int half = metrics.horizontalAdvance("0000.0 s") / 2;
  plot->axisWidget(QwtPlot::xBottom)->setMinBorderDist(half, half);
  plot->axisWidget(QwtPlot::yLeft)->setMinBorderDist(metrics.height() / 2, metrics.height() / 2);
  plot->plotLayout()->setAlignCanvasToScales(true);
  auto* grid = new QwtPlotGrid;
  grid->setPen(kGridColour, 0);
  grid->attach(plot);
  return plot;
}

QColor curveColour(const QString& name, int index) {
  const QColor red(0xc4, 0x3d, 0x3d), green(0x2e, 0x8b, 0x57), blue(0x2b, 0x6c, 0xb8);
  if (name == "x") return red;
  if (name == "y") return green;
  if (name == "z") return blue;
  static const std::array<QColor, 5> kOthers = {QColor(0xd0, 0x24, 0x36), QColor(0x21, 0x73, 0xdb),
                                                QColor(0x7a, 0x4f, 0xa3), QColor(0x6b, 0x6f, 0x14),
                                                QColor(0x44, 0x4a, 0x50)};
  return kOthers[static_cast<std::size_t>(index) % kOthers.size()];
}

QString plotHeader(const QString& title, const std::vector<QString>& names) {
  QString text = "<b>" + title.toHtmlEscaped() + "</b>";
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += QString("&nbsp;&nbsp; <span style='color:%1'>&#9644;&nbsp;%2</span>")
                .arg(curveColour(names[i], static_cast<int>(i)).name(), names[i].toHtmlEscaped());
  }
  return text;
}

}  // namespace haptiv
