#include "app/plots/PlotGesture.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

namespace haptiv {
namespace {

constexpr double kZoomPerNotch = 0.8;  // of the shown span

}  // namespace

PlotGesture gestureOf(const QEvent& event, const QwtPlot& plot) {
  using Kind = PlotGesture::Kind;
  const auto timeAt = [&plot](double x) { return plot.canvasMap(QwtPlot::xBottom).invTransform(x); };
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove: {
      const auto& move = static_cast<const QMouseEvent&>(event);
      if (!(move.buttons() & Qt::LeftButton)) return {};
      return {Kind::pick, timeAt(move.localPos().x())};
    }
    case QEvent::MouseButtonDblClick:
      return {Kind::showAll};
    case QEvent::Wheel: {
      const auto& wheel = static_cast<const QWheelEvent&>(event);
      const double notches = wheel.angleDelta().y() / 120.0;
      return {Kind::zoom, timeAt(wheel.position().x()), std::pow(kZoomPerNotch, notches)};
    }
    default:
      return {};
  }
}

}  // namespace haptiv
