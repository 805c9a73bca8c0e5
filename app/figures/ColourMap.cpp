#include "app/figures/ColourMap.h"

#include <qwt_color_map.h>
#include <qwt_matrix_raster_data.h>
#include <qwt_plot.h>
#include <qwt_plot_spectrogram.h>
#include <qwt_scale_widget.h>

#include <algorithm>
#include <cmath>

namespace haptiv {
namespace {

constexpr int kBarWidth = 18;  // [pixels]

/// Dark blue over green to yellow, lighter and lighter: it reads in grey too. NaN is transparent.
QwtColorMap* makeColours() {
  auto* colours = new QwtLinearColorMap(QColor(0x44, 0x01, 0x54), QColor(0xfd, 0xe7, 0x25));
  colours->addColorStop(0.13, QColor(0x47, 0x2d, 0x7b));
  colours->addColorStop(0.25, QColor(0x3b, 0x52, 0x8b));
  colours->addColorStop(0.38, QColor(0x2c, 0x72, 0x8e));
  colours->addColorStop(0.5, QColor(0x21, 0x91, 0x8c));
  colours->addColorStop(0.63, QColor(0x28, 0xae, 0x80));
  colours->addColorStop(0.75, QColor(0x5e, 0xc9, 0x62));
  colours->addColorStop(0.88, QColor(0xad, 0xdc, 0x30));
  return colours;
}

}  // namespace

std::pair<double, double> colourRange(const FigureMap& map) {
  if (map.range) return *map.range;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const double value : map.values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return {0, 1};
  return {low, high > low ? high : low + 1};
}

void addColours(QwtPlot& plot, const FigureMap& map) {
  const auto [low, high] = colourRange(map);
  auto* data = new QwtMatrixRasterData;
  data->setValueMatrix(QVector<double>(map.values.begin(), map.values.end()), map.columns);
  data->setInterval(Qt::XAxis, {map.x.first, map.x.second});
  data->setInterval(Qt::YAxis, {map.y.first, map.y.second});
  data->setInterval(Qt::ZAxis, {low, high});
  auto* item = new QwtPlotSpectrogram;
  item->setRenderThreadCount(1);
  item->setData(data);
  item->setColorMap(makeColours());
  item->attach(&plot);

  auto* bar = plot.axisWidget(QwtPlot::yRight);
  bar->setColorBarEnabled(true);
  bar->setColorBarWidth(kBarWidth);
  bar->setColorMap({low, high}, makeColours());
}

}  // namespace haptiv
