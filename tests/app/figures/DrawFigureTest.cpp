#include "app/figures/DrawFigure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/figures/LineStyle.h"
#include "app/figures/OffscreenQt.h"

namespace haptiv {
namespace {

// Pixels within `part` that are just about of this colour.
int count(const QImage& image, const QColor& colour, const QRect& part) {
  int pixels = 0;
  for (int y = part.top(); y <= part.bottom(); ++y) {
    for (int x = part.left(); x <= part.right(); ++x) {
      const QColor is = image.pixelColor(x, y);
      const int off = std::abs(is.red() - colour.red()) + std::abs(is.green() - colour.green()) +
                      std::abs(is.blue() - colour.blue());
      pixels += off < 30;
    }
  }
  return pixels;
}

Figure sine() {
  Figure figure{"A sine", {{"sine", 2}}, {{"left", {"t [s]", {}, {}}, {"y", {}, {}}, {}, {}, {}, false}}, 1};
  FigureCurve curve;
  curve.style = 2;
  for (int i = 0; i <= 1000; ++i) {
    curve.x.push_back(i / 100.);
    curve.y.push_back(std::sin(i / 100.));
  }
  figure.panels[0].curves.push_back(curve);
  return figure;
}

class DrawFigure : public testing::Test {
 protected:
  OffscreenQt qt_;
};

TEST_F(DrawFigure, DrawsTheCurveAndItsKey) {
  const QImage image = drawFigure(sine());
  EXPECT_EQ(image.size(), QSize(1280, 720));
  const QColor colour = linePen(2).color();
  EXPECT_GT(count(image, colour, {0, 0, 1280, 90}), 40) << "the legend's sample of the line";
  EXPECT_GT(count(image, colour, {0, 90, 1280, 630}), 1000) << "the curve";
}

TEST_F(DrawFigure, WritesRealLettersAndNoBoxes) {
  // Without a font every letter is the same box.
  const auto ink = [](const std::string& title) {
    Figure figure;
    figure.title = title;
    return count(drawFigure(figure), QColor(0x24, 0x29, 0x2e), {0, 0, 1280, 60});
  };
  EXPECT_GT(ink("iiiiiiii"), 50);
  EXPECT_GT(ink("MMMMMMMM"), 2 * ink("iiiiiiii"));
}

TEST_F(DrawFigure, GivesTheSamePictureTwice) {
  EXPECT_EQ(drawFigure(sine()), drawFigure(sine()));
}

TEST_F(DrawFigure, LeavesGapsWhereAValueIsNotFinite) {
  Figure figure = sine();
  const int whole = count(drawFigure(figure), linePen(2).color(), {0, 90, 1280, 630});
  for (int i = 200; i < 800; ++i) figure.panels[0].curves[0].y[static_cast<std::size_t>(i)] = NAN;
  const int rest = count(drawFigure(figure), linePen(2).color(), {0, 90, 1280, 630});
  EXPECT_GT(rest, 0);
  EXPECT_LT(rest, 0.7 * whole);
}

TEST_F(DrawFigure, DrawsAMapWithItsBarAndLeavesNanWhite) {
  Figure figure;
  FigurePanel& panel = figure.panels.emplace_back();
  panel.map = FigureMap{{0, 2}, {0, 1}, 2, {0.0, NAN}, "m", std::pair(0., 1.)};
  const QImage image = drawFigure(figure);
  EXPECT_NE(image.pixelColor(300, 350), QColor(Qt::white));
  EXPECT_EQ(image.pixelColor(800, 350), QColor(Qt::white));
  EXPECT_GT(count(image, QColor(0xfd, 0xe7, 0x25), {1100, 0, 180, 720}), 10) << "the bar's upper end";
}

TEST_F(DrawFigure, DrawsEmptyFiguresAndCurvesWithoutPoints) {
  Figure figure;
  EXPECT_FALSE(drawFigure(figure).isNull());
  figure.panels.resize(3);
  figure.columns = 2;
  figure.panels[0].curves.emplace_back();
  EXPECT_FALSE(drawFigure(figure).isNull());
}

}  // namespace
}  // namespace haptiv
