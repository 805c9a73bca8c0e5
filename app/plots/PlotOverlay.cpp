#include "app/plots/PlotOverlay.h"

#include <algorithm>
#include <cmath>

namespace haptiv {

PlotOverlay::PlotOverlay(QwtPlot& plot)
    : plot_(plot), cursor_(new QWidget(plot.canvas())), note_(new QLabel("nothing to show yet", plot.canvas())) {
  cursor_->setAttribute(Qt::WA_TransparentForMouseEvents);
  cursor_->setAutoFillBackground(true);
  cursor_->setPalette(QPalette(QColor(0x30, 0x36, 0x3c)));
  cursor_->hide();
  note_->setAttribute(Qt::WA_TransparentForMouseEvents);
  note_->setAlignment(Qt::AlignCenter);
  note_->setWordWrap(true);
  note_->setStyleSheet("color: #868e96");
}

void PlotOverlay::showNote(bool shown) {
  note_->setVisible(shown);
  note_->setGeometry(plot_.canvas()->rect());
}

void PlotOverlay::placeCursor(std::optional<double> time) {
  if (time) {
    const int x = static_cast<int>(std::lround(plot_.canvasMap(QwtPlot::xBottom).transform(*time)));
    cursor_->setGeometry(std::min(x, plot_.canvas()->width() - 1), 0, 1, plot_.canvas()->height());
  }
  cursor_->setVisible(time.has_value());
}

}  // namespace haptiv
