#include "haptics/contact/RememberedBlocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "haptics/laws/IfThenRenderer.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::kRest;
using testing::meshWall;
using testing::moved;
using testing::RandomShapes;
using testing::sceneOf;
using testing::Soup;
using testing::sphereSoup;

using Blocks = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  ///< wall and block

Blocks blocksOf(const HapticScene& scene, const Vector3& p, double reach) {
  Blocks blocks;
  std::array<std::uint32_t, 1024> room;
  for (std::uint32_t wall = 0; wall < scene.walls.size(); ++wall) {
    const auto count = scene.walls[wall].shape.mesh->tree.listWithin({p, p}, reach, room, [](std::uint32_t) {});
    for (std::size_t i = 0; i < count.value_or(0); ++i) blocks.emplace_back(wall, room[i]);
  }
  return blocks;
}

Blocks blocksOf(const HapticScene& scene, const GatheredBlocks& gathered, const Vector3& p, double reach) {
  Blocks blocks;
  std::array<std::uint32_t, 1024> room;
  EXPECT_TRUE(
      gathered.forEachWall(scene, {p, p}, reach, room, [&](std::uint32_t wall, std::span<const std::uint32_t> found) {
        for (const std::uint32_t block : found) blocks.emplace_back(wall, block);
        return true;
      }));
  return blocks;
}

/// Two spheres that overlap.
HapticScene twoSpheres(int n) {
  return sceneOf(
      {meshWall(sphereSoup(0.1, n)), meshWall(moved(sphereSoup(0.1, n), Matrix3::Identity(), {0.12, 0.03, 0.01}))});
}

TEST(GatheredBlocks, AreThoseOfTheTreesInTheirOrderHoweverTheyWereGathered) {
  RandomShapes random(21);
  const HapticScene scene = twoSpheres(40);
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    const Vector3 centre = 0.1 * random.direction();
    const double reach = random.between(0.002, 0.03);
    GatheredBlocks gathered;
    gathered.start(scene, centre, reach);
    while (!gathered.isComplete()) gathered.goOn(scene, 1 + static_cast<std::size_t>(round % 7));
    if (!gathered.fits()) continue;
    for (int k = 0; k < 5; ++k) {
      const double part = random.between(0.1, 0.9);
      const Vector3 p = centre + (1 - part) * reach * random.between(0, 0.99) * random.direction();
      ASSERT_TRUE(gathered.holds(p, part * reach));
      EXPECT_FALSE(gathered.holds(p, 2.1 * reach));
      const Blocks blocks = blocksOf(scene, p, part * reach);
      ASSERT_EQ(blocksOf(scene, gathered, p, part * reach), blocks);
      found += static_cast<int>(blocks.size());
    }
  }
  EXPECT_GT(found, 1000);
}

TEST(GatheredBlocks, DoNotFitWhereTheyAreTooMany) {
  const HapticScene scene = twoSpheres(100);
  GatheredBlocks gathered;
  gathered.start(scene, {0, 0, 0}, 1);
  for (int i = 0; i < 1000 && !gathered.isComplete(); ++i) gathered.goOn(scene, 1);
  EXPECT_TRUE(gathered.isComplete());
  EXPECT_FALSE(gathered.fits());
}

/// A hand that wanders about the surface: slowly and fast, with halts, turns and jumps.
class BallOverMeshes {
 public:
  explicit BallOverMeshes(unsigned seed) : random_(seed) {}
  Vector3 next(double radius) {
    if (tick_++ % 50 == 0) {
      speed_ = radius * std::pow(10, random_.between(-3, 0));
      heading_ = random_.direction();
      depth_ = radius * random_.between(-0.7, 0.2);
    }
    if (tick_ % 700 == 0) place_ = random_.direction();
    if (tick_ % 3 == 0) heading_ = (heading_ + 0.1 * random_.direction()).normalized();
    place_ = (place_ + speed_ / 0.1 * heading_).normalized();
    height_ += 0.1 * (depth_ - height_);
    return (0.1 + radius + height_) * place_;
  }

 private:
  RandomShapes random_;
  int tick_ = 0;
  double speed_ = 0, depth_ = 0, height_ = 0;
  Vector3 place_ = Vector3::UnitX(), heading_ = Vector3::UnitY();
};

/// Of small and of large balls: there the triangles are too many to be remembered, or even to be kept in a tick.
TEST(RememberedBlocks, RestNeverTwiceInARow) {
  RememberedBlocks blocks;
  EXPECT_FALSE(blocks.mayRest(false));
  EXPECT_TRUE(blocks.mayRest(true));
  EXPECT_FALSE(blocks.mayRest(true));
  EXPECT_TRUE(blocks.mayRest(true));
  EXPECT_FALSE(blocks.mayRest(false));
  EXPECT_TRUE(blocks.mayRest(true));
}

TEST(RememberedBlocks, ChangeNothingButTheTime) {
  for (const double radius : {0.002, 0.01, 0.04}) {
    HapticScene scene = twoSpheres(60);
    scene.version = 1;
    BallOverMeshes hand(static_cast<unsigned>(1e4 * radius));
    ContactSet remembering, forgetful;
    int touched = 0, remembered = 0;
    for (int tick = 0; tick < 6000; ++tick) {
      if (tick % 900 == 899) {  // an edit: the blocks are other ones, and fewer
        scene = twoSpheres(60 - tick / 300);
        scene.version = static_cast<std::uint32_t>(tick);
      }
      const Vector3 p = hand.next(radius);
      remembered += remembering.blocks.around(remembering.surfacePosition, 0.5 * radius) != nullptr ? 1 : 0;
      forgetful.blocks.forget();
      const Vector3 force = renderWalls(scene, {p, kRest, radius}, remembering);
      ASSERT_EQ(force, renderWalls(scene, {p, kRest, radius}, forgetful)) << radius << " " << tick;
      ASSERT_EQ(remembering.surfacePosition, forgetful.surfacePosition);
      ASSERT_EQ(remembering.count, forgetful.count);
      touched += remembering.count > 0 ? 1 : 0;
    }
    EXPECT_GT(touched, 1000) << radius;
    if (radius < 0.01) {
      EXPECT_GT(remembered, 2000);
    }
  }
}

/// Else they would be of no use to a hand that goes straight on.
TEST(RememberedBlocks, AreKnownBeforeTheyAreNeeded) {
  const HapticScene scene = sceneOf({meshWall(sphereSoup(0.1, 100))});
  for (const double perTick : {1e-5, 1e-4, 4e-4}) {
    ContactSet contacts;
    int known = 0, ticks = 0;
    for (double angle = 0; angle < 1; angle += perTick / 0.1, ++ticks) {
      const Vector3 p = 0.101 * Vector3(std::cos(angle), std::sin(angle), 0.3).normalized();
      renderWalls(scene, {p, kRest, 0.002}, contacts);
      known += contacts.blocks.around(contacts.surfacePosition, 0.0021) != nullptr ? 1 : 0;
    }
    EXPECT_GT(known, 0.95 * ticks - 100) << perTick;
  }
}

}  // namespace
}  // namespace haptiv
