#include "app/figures/PanelPlot.h"

#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>

#include <algorithm>
#include <cmath>

#include "app/figures/ColourMap.h"
#include "app/figures/CurveItem.h"

namespace haptiv {
namespace {

constexpr int kTickLetters = 15, kLabelLetters = 17, kPanelLetters = 17;  // [pixels]
constexpr double kRoom = 0.03;                                            // above the curves, of their span
constexpr double kAboveAll = 30;                                          // maps and grids are below
const QColor kGridColour(0xe3, 0xe6, 0xe9);
const QColor kPanelInk(0x24, 0x29, 0x2e);

class NamedTicks : public QwtScaleDraw {
 public:
  explicit NamedTicks(const FigureAxis& axis) : ticks_(axis.ticks) {}
  QwtText label(double value) const override {
    for (const auto& [at, text] : ticks_) {
      if (std::abs(at - value) < 1e-9 * (1 + std::abs(at))) return QString::fromStdString(text);
    }
    return {};
  }

 private:
  std::vector<std::pair<double, std::string>> ticks_;
};

struct Span {
  double low = INFINITY, high = -INFINITY;
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool any() const { return low <= high; }
};

/// Of what is drawn; upwards with room, so that curves keep off the frame, and from zero where that is not far.
Span spanOf(const FigurePanel& panel, bool x) {
  Span span;
  for (const FigureCurve& curve : panel.curves) {
    for (const double value : x ? curve.x : curve.y) span.add(value);
  }
  if (panel.map) {
    const auto [low, high] = x ? panel.map->x : panel.map->y;
    span.add(low);
    span.add(high);
  }
  if (x || panel.map || !span.any()) return span;
  const double room = kRoom * (span.high - span.low);
  span.high += room;
  if (span.low >= 0 && span.low < span.high / 2) {
    span.low = 0;
  } else {
    span.low -= room;
  }
  return span;
}

void setUpAxis(QwtPlot& plot, int id, const FigureAxis& axis, const Span& span) {
  auto* widget = plot.axisWidget(id);
  QwtText title(QString::fromStdString(axis.label));
  title.setFont(figureFont(kLabelLetters));
  title.setColor(kPanelInk);
  plot.setAxisTitle(id, title);
  plot.setAxisFont(id, figureFont(kTickLetters));
  QPalette palette = widget->palette();
  palette.setColor(QPalette::WindowText, kPanelInk);
  palette.setColor(QPalette::Text, kPanelInk);
  widget->setPalette(palette);
  widget->setMargin(2);
  widget->setSpacing(4);
  widget->setMinBorderDist(kTickLetters, kTickLetters);  // so that the canvases of a row are as high as each other
  plot.setAxisMaxMinor(id, 0);
  plot.setAxisMaxMajor(id, 7);

  const double low = axis.range ? axis.range->first : span.any() ? span.low : 0;
  double high = axis.range ? axis.range->second : span.any() ? span.high : 1;
  if (!(high > low)) high = low + 1;
  if (axis.ticks.empty()) {
    plot.setAxisScale(id, low, high);
    return;
  }
  QList<double> majors;
  for (const auto& [at, text] : axis.ticks) majors << at;
  plot.setAxisScaleDraw(id, new NamedTicks(axis));
  plot.setAxisScaleDiv(id, QwtScaleDiv(low, high, {}, {}, majors));
}

void addNote(QwtPlot& plot, const FigureNote& note) {
  QwtText text(QString::fromStdString(note.text));
  text.setFont(figureFont(kTickLetters));
  text.setColor(kPanelInk);
  auto* marker = new QwtPlotMarker;
  marker->setValue(note.x, note.y);
  marker->setLabel(text);
  marker->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
  marker->setSpacing(8);
  marker->setZ(kAboveAll);
  marker->attach(&plot);
}

}  // namespace

QFont figureFont(int pixels, bool bold) {
  QFont font("DejaVu Sans");
  font.setStyleHint(QFont::SansSerif);
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

std::unique_ptr<QwtPlot> makePanelPlot(const FigurePanel& panel) {
  auto plot = std::make_unique<QwtPlot>();
  plot->setAutoReplot(false);
  auto* canvas = new QwtPlotCanvas;
  canvas->setFrameShape(QFrame::Box);
  canvas->setFrameShadow(QFrame::Plain);
  canvas->setLineWidth(1);
  canvas->setPalette(QPalette(kPanelInk, Qt::white));
  plot->setCanvas(canvas);
  plot->setCanvasBackground(Qt::white);
  if (!panel.title.empty()) {
    QwtText title(QString::fromStdString(panel.title));
    title.setFont(figureFont(kPanelLetters, true));
    title.setColor(kPanelInk);
    plot->setTitle(title);
  }
  plot->plotLayout()->setAlignCanvasToScales(true);
  setUpAxis(*plot, QwtPlot::xBottom, panel.x, spanOf(panel, true));
  setUpAxis(*plot, QwtPlot::yLeft, panel.y, spanOf(panel, false));
  if (panel.map) {
    plot->enableAxis(QwtPlot::yRight);
    setUpAxis(*plot, QwtPlot::yRight, {panel.map->label, colourRange(*panel.map), {}}, {});
    addColours(*plot, *panel.map);
  } else {
    auto* grid = new QwtPlotGrid;
    grid->setPen(kGridColour, 1);
    grid->attach(plot.get());
  }
  for (const FigureCurve& curve : panel.curves) {
    auto* item = new CurveItem(curve);
    item->setZ(kAboveAll);
    item->attach(plot.get());
  }
  for (const FigureNote& note : panel.notes) addNote(*plot, note);
  plot->updateAxes();
  return plot;
}

void equaliseScales(QwtPlot& plot, const QRectF& area) {
  plot.plotLayout()->activate(&plot, area);
  const QRectF canvas = plot.plotLayout()->canvasRect();
  QwtInterval x = plot.axisInterval(QwtPlot::xBottom), y = plot.axisInterval(QwtPlot::yLeft);
  const double unit = std::max(x.width() / canvas.width(), y.width() / canvas.height());  // a pixel's
  const auto widen = [&plot](int axis, const QwtInterval& span, double width) {
    const double middle = (span.minValue() + span.maxValue()) / 2;
    plot.setAxisScale(axis, middle - width / 2, middle + width / 2);
  };
  widen(QwtPlot::xBottom, x, unit * canvas.width());
  widen(QwtPlot::yLeft, y, unit * canvas.height());
  plot.updateAxes();
}

}  // namespace haptiv
