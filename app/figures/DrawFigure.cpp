#include "app/figures/DrawFigure.h"

#include <qwt_plot_renderer.h>

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "app/figures/LineStyle.h"
#include "app/figures/PanelPlot.h"

namespace haptiv {
namespace {

constexpr int kMargin = 16, kGap = 24;                  // [pixels]
constexpr int kTitleLetters = 20, kLegendLetters = 17;  // [pixels]
constexpr int kSample = 48;                             // of a line in the legend [pixels]
constexpr double kWidest = 1.4;                         // a panel of equal scales, over its height
const QColor kInk(0x24, 0x29, 0x2e);

/// From `top` down; returns where it ends.
int drawTitle(QPainter& painter, const std::string& title, int width, int top) {
  if (title.empty()) return top;
  painter.setFont(figureFont(kTitleLetters, true));
  painter.setPen(kInk);
  const int height = painter.fontMetrics().height();
  painter.drawText(QRect(kMargin, top, width - 2 * kMargin, height), Qt::AlignHCenter | Qt::AlignVCenter,
                   QString::fromStdString(title));
  return top + height + 8;
}

/// As many keys in a row as there is room for, in the middle; returns where it ends.
int drawLegend(QPainter& painter, const std::vector<FigureKey>& legend, int width, int top) {
  painter.setFont(figureFont(kLegendLetters));
  const QFontMetrics metrics = painter.fontMetrics();
  const auto widthOf = [&metrics](const FigureKey& key) {
    return kSample + 8 + metrics.horizontalAdvance(QString::fromStdString(key.text));
  };
  const int height = metrics.height() + 6;
  for (std::size_t first = 0; first < legend.size();) {
    std::size_t end = first;
    int used = -kGap;
    while (end < legend.size() && (end == first || used + kGap + widthOf(legend[end]) <= width - 2 * kMargin))
      used += kGap + widthOf(legend[end++]);
    int x = (width - used) / 2;
    for (; first < end; ++first) {
      const FigureKey& key = legend[first];
      const double middle = top + height / 2.0;
      painter.setPen(linePen(key.style));
      if (key.line) painter.drawLine(QPointF(x, middle), QPointF(x + kSample, middle));
      if (key.markers) drawMarker(painter, key.style, {x + kSample / 2.0, middle});
      painter.setPen(kInk);
      painter.drawText(QRect(x + kSample + 8, top, widthOf(key), height), Qt::AlignLeft | Qt::AlignVCenter,
                       QString::fromStdString(key.text));
      x += widthOf(key) + kGap;
    }
    top += height;
  }
  return legend.empty() ? top : top + 6;
}

}  // namespace

QImage drawFigure(const Figure& figure, int width, int height) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  int top = drawTitle(painter, figure.title, width, kMargin);
  top = drawLegend(painter, figure.legend, width, top);

  const int columns = std::max(1, figure.columns);
  const int rows = (static_cast<int>(figure.panels.size()) + columns - 1) / columns;
  const double cellWidth = (width - 2.0 * kMargin - (columns - 1) * kGap) / columns;
  const double cellHeight = (height - kMargin - top - (rows - 1.0) * kGap) / std::max(1, rows);
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  for (int i = 0; i < static_cast<int>(figure.panels.size()); ++i) {
    QRectF cell(kMargin + (i % columns) * (cellWidth + kGap), top + (i / columns) * (cellHeight + kGap), cellWidth,
                cellHeight);
    const FigurePanel& panel = figure.panels[static_cast<std::size_t>(i)];
    const auto plot = makePanelPlot(panel);
    if (panel.equalScales) {
      const double spare = std::max(0., cell.width() - kWidest * cell.height()) / 2;
      cell.adjust(spare, 0, -spare, 0);
      equaliseScales(*plot, cell);
    }
    renderer.render(plot.get(), &painter, cell);
  }
  return image;
}

}  // namespace haptiv
