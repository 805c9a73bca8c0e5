#include "app/dexterity/RateBars.h"

#include <gtest/gtest.h>

#include <QImage>

#include "app/dexterity/DexterityColours.h"

namespace haptiv {
namespace {

class RateBarsTest : public ::testing::Test {
 protected:
  RateBarsTest() { bars_.setJoints(3, JointVector::Constant(4)); }

  /// Mean place, in widths of the widget, of all pixels of this colour; -1: there is none.
  double placeOf(const QColor& colour) {
    bars_.resize(300, bars_.sizeHint().height());
    const QImage image = bars_.grab().toImage().convertToFormat(QImage::Format_RGB32);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, y) == colour) sum += x, ++count;
    return count > 0 ? sum / count / image.width() : -1;
  }

  void show(double rate) {
    JointVector rates = JointVector::Zero();
    rates[1] = rate;
    bars_.show(rates);
  }

  RateBars bars_;
};

TEST_F(RateBarsTest, APositiveRateLiesRightOfANegativeOne) {
  show(2);
  const double right = placeOf(DexterityColours::good());
  show(-2);
  const double left = placeOf(DexterityColours::good());
  EXPECT_GT(left, 0);
  EXPECT_GT(right, left);
}

TEST_F(RateBarsTest, TurnAmberNearTheLimitAndRedAtIt) {
  show(0.5 * 4);
  EXPECT_LT(placeOf(DexterityColours::near()), 0);
  show(0.9 * 4);
  EXPECT_GT(placeOf(DexterityColours::near()), 0);
  EXPECT_LT(placeOf(DexterityColours::bad()), 0);
  show(-4);
  EXPECT_GT(placeOf(DexterityColours::bad()), 0);
}

TEST_F(RateBarsTest, HaveRoomForTheArmsJointsAndNoMore) {
  const int three = bars_.sizeHint().height();
  bars_.setJoints(7, JointVector::Constant(4));
  EXPECT_EQ(bars_.jointCount(), 7);
  EXPECT_EQ(bars_.sizeHint().height(), three * 2) << "one row a joint, and a heading";
}

}  // namespace
}  // namespace haptiv
