#include "app/bench/wall/WallMap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/bench/wall/WallFigure.h"
#include "app/bench/wall/WallTables.h"

namespace haptiv {
namespace {

TEST(WallTouch, FindsASoftDampedWallStableAndAnAbsurdOneNot) {
  const WallTouch touch(loadDeviceDescription("vishard10"), 1000);
  for (const Grip& grip : kGrips) {
    const WallOutcome soft = touch({WallVariant::law, grip, 40, 1000});
    EXPECT_TRUE(soft.isStable) << grip.name << ": " << soft.oscillation << " N";
    EXPECT_FALSE(touch({WallVariant::law, grip, 0, 3e7}).isStable) << grip.name;
    EXPECT_EQ(touch({WallVariant::law, grip, 40, 1000}).oscillation,
              soft.oscillation);  // the same trial, the same bits
  }
}

TEST(WallMap, GoesFromTheNetToLimitsFigureAndTables) {
  WallNet net;
  net.damping = {20, 40};
  net.stiffness = {1000, 1e6, 1e9};
  net.refinements = 1;
  int told = 0;
  const WallMap map = mapWalls(loadDeviceDescription("vishard10"), 1000, net, [&](const std::string&) { ++told; });
  EXPECT_GT(told, 0);
  EXPECT_EQ(map.trials, map.tickNs.size());
  EXPECT_DOUBLE_EQ(map.optimalStiffness(40), 400);  // 40^2 / (2 * 2 kg)
  ASSERT_EQ(map.shaking.size(), std::size(kGrips));
  ASSERT_EQ(map.limits.size(), std::size(kGrips) * std::size(kWallVariants));
  for (const WallLimit& limit : map.limits) {
    ASSERT_EQ(limit.stiffness.size(), 2u);
    for (const double stiffness : limit.stiffness) {
      EXPECT_GE(stiffness, 1000);
      EXPECT_LT(stiffness, 1e9);
    }
  }
  const Figure figure = wallFigure(map);
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[0].map->values.size(), 6u);
  EXPECT_EQ(figure.panels[0].curves.size(), 5u);
  const FigureCurve& optimum = figure.panels[0].curves.back();
  for (std::size_t i = 0; i < optimum.x.size(); ++i)
    EXPECT_NEAR(std::pow(10, optimum.y[i]), map.optimalStiffness(std::pow(10, optimum.x[i])),
                1e-9 * std::pow(10, optimum.y[i]));
  EXPECT_NE(wallTable(map).find("passivity"), std::string::npos);
  EXPECT_NE(wallLimitsCsv(map).find("firm,both-ways,40,400,"), std::string::npos);
}

}  // namespace
}  // namespace haptiv
