#include "haptics/SceneBytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using testing::RandomShapes;

HapticScene richScene() {
  RandomShapes random(1);
  HapticScene scene;
  scene.version = 42;
  scene.tool = {2.5, 4, 0.015, {0.1, 0.2, 0.3}};
  scene.device = {"arm.toml", random.vector(1), random.rotation(), 1.5};
  scene.resolution = ResolutionChoice{Strategy::cond, Solution::partitioned};
  for (int i = 0; i < 8; ++i) {
    Wall wall;
    wall.id = static_cast<ShapeId>(100 + i);
    wall.shape = random.shape(static_cast<Shape::Kind>(i % 4));
    wall.surface = {random.between(1, 9), random.between(1, 9), 0.001, 0.4, 0.3};
    scene.walls.push_back(wall);
    Zone zone;
    zone.id = static_cast<ShapeId>(200 + i);
    zone.kind = i % 2 == 0 ? Zone::Kind::viscous : Zone::Kind::spring;
    zone.shape = random.shape(static_cast<Shape::Kind>(i % 4));
    zone.restLength = random.between(0, 1);
    zone.anchor = random.vector(1);
    scene.zones.push_back(zone);
  }
  return scene;
}

std::string errorOf(const std::vector<std::byte>& bytes) {
  try {
    sceneFromBytes(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(SceneBytes, ReadBackToTheSameScene) {
  const HapticScene scene = richScene();
  const HapticScene read = sceneFromBytes(toBytes(scene));
  EXPECT_EQ(read.version, 42u);
  EXPECT_EQ(read.tool.mass, scene.tool.mass);
  EXPECT_EQ(read.tool.home, scene.tool.home);
  EXPECT_EQ(read.device.description, "arm.toml");
  EXPECT_EQ(read.device.rotation, scene.device.rotation);
  EXPECT_EQ(read.resolution, scene.resolution);
  ASSERT_EQ(read.walls.size(), 8u);
  EXPECT_EQ(read.walls[7].id, 107u);
  EXPECT_EQ(read.walls[7].shape.kind, Shape::Kind::cone);
  EXPECT_EQ(read.walls[7].shape.axes, scene.walls[7].shape.axes);
  EXPECT_EQ(read.walls[7].surface.dynamicFriction, 0.3);
  ASSERT_EQ(read.zones.size(), 8u);
  EXPECT_EQ(read.zones[3].kind, Zone::Kind::spring);
  EXPECT_EQ(read.zones[3].anchor, scene.zones[3].anchor);
  EXPECT_EQ(read.wallIndex.tree.size(), 8u);
  EXPECT_EQ(toBytes(read), toBytes(scene));
}

TEST(SceneBytes, ReadAnEmptyScene) {
  const HapticScene read = sceneFromBytes(toBytes({}));
  EXPECT_EQ(read.walls.size(), 0u);
  EXPECT_FALSE(read.resolution);
}

/// Format 1 had no choice of a resolution, and arms moved by least norm.
TEST(SceneBytes, ReadTheFirstFormat) {
  std::vector<std::byte> bytes = toBytes({});
  const std::size_t counts = 2 * sizeof(std::uint32_t), choice = 2;
  bytes.erase(bytes.end() - counts - choice, bytes.end() - counts);
  bytes[8] = std::byte{1};
  EXPECT_EQ(sceneFromBytes(bytes).resolution, ResolutionChoice{});
}

TEST(SceneBytes, RefuseEveryCutOffScene) {
  const std::vector<std::byte> whole = toBytes(richScene());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::byte> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THAT(errorOf(cut), HasSubstr("at byte")) << size;
  }
}

TEST(SceneBytes, RefuseAnotherFormatByItsNumber) {
  std::vector<std::byte> bytes = toBytes(richScene());
  bytes[8] = std::byte{9};
  EXPECT_THAT(errorOf(bytes), HasSubstr("format 9"));
  bytes[0] = std::byte{0};
  EXPECT_THAT(errorOf(bytes), HasSubstr("no compiled scene"));
}

TEST(SceneBytes, RefuseWhatFollowsTheScene) {
  std::vector<std::byte> bytes = toBytes(richScene());
  bytes.push_back(std::byte{0});
  EXPECT_THAT(errorOf(bytes), HasSubstr("1 bytes too many"));
}

TEST(SceneBytes, RefuseAnnouncedCountsBeforeMakingRoomForThem) {
  std::vector<std::byte> bytes = toBytes({});
  for (std::size_t i = bytes.size() - 8; i < bytes.size() - 4; ++i) bytes[i] = std::byte{0xff};
  EXPECT_THAT(errorOf(bytes), HasSubstr("4294967295 entries"));
}

TEST(SceneBytes, SurviveRandomDamage) {
  const std::vector<std::byte> whole = toBytes(richScene());
  std::mt19937 engine(7);
  int refused = 0;
  for (int run = 0; run < 5000; ++run) {
    std::vector<std::byte> bytes = whole;
    for (int i = 0; i < 4; ++i) bytes[engine() % bytes.size()] = static_cast<std::byte>(engine() & 0xff);
    try {
      const HapticScene scene = sceneFromBytes(bytes);
      EXPECT_EQ(toBytes(scene), bytes);
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace haptiv
