#include "haptics/bytes/SceneBytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using testing::RandomShapes;
using testing::sphereSoup;

HapticScene richScene() {
  RandomShapes random(1);
  HapticScene scene;
  scene.version = 42;
  scene.tool = {2.5, 4, 0.015, {0.1, 0.2, 0.3}};
  scene.device = {"arm.toml", random.vector(1), random.rotation(), 1.5};
  scene.resolution = ResolutionChoice{Strategy::cond, Solution::partitioned};
  scene.control = ControlChoice{DisplayMode::impedance, JointController::computedTorque, OrientationMode::free, true};
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
  scene.walls.emplace_back();
  scene.walls.back().shape.kind = Shape::Kind::mesh;
  scene.walls.back().shape.mesh = sphereSoup(0.2, 3).mesh();
  scene.zones.emplace_back();
  scene.zones.back().kind = Zone::Kind::rubberBand;
  scene.zones.back().shape = scene.walls.back().shape;
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
  EXPECT_EQ(read.control, scene.control);
  ASSERT_EQ(read.walls.size(), 9u);
  EXPECT_EQ(read.walls[7].id, 107u);
  EXPECT_EQ(read.walls[7].shape.kind, Shape::Kind::cone);
  EXPECT_EQ(read.walls[7].shape.axes, scene.walls[7].shape.axes);
  EXPECT_EQ(read.walls[7].surface.dynamicFriction, 0.3);
  ASSERT_EQ(read.zones.size(), 9u);
  EXPECT_EQ(read.zones[3].kind, Zone::Kind::spring);
  EXPECT_EQ(read.zones[3].anchor, scene.zones[3].anchor);
  EXPECT_EQ(read.wallIndex.tree.size(), 9u);
  EXPECT_EQ(toBytes(read), toBytes(scene));
}

TEST(SceneBytes, ReadAnEmptyScene) {
  const HapticScene read = sceneFromBytes(toBytes({}));
  EXPECT_EQ(read.walls.size(), 0u);
  EXPECT_FALSE(read.resolution);
  EXPECT_FALSE(read.control);
}

/// Format 1 had no choice of a resolution, and arms moved by least norm.
/// The newest form of an empty scene ends with: choice of a resolution, of control, meshes known, new meshes, walls,
/// zones.
TEST(SceneBytes, ReadTheFirstFormats) {
  const std::ptrdiff_t counts = 2 * sizeof(std::uint32_t), meshes = counts, choice = 2, control = 1;
  std::vector<std::byte> bytes = toBytes({});
  bytes.erase(bytes.end() - counts - meshes - control, bytes.end() - counts - meshes);
  bytes[8] = std::byte{3};
  EXPECT_EQ(sceneFromBytes(bytes).control, std::nullopt);
  bytes.erase(bytes.end() - counts - meshes, bytes.end() - counts);
  bytes[8] = std::byte{2};
  EXPECT_EQ(sceneFromBytes(bytes).resolution, std::nullopt);
  bytes.erase(bytes.end() - counts - choice, bytes.end() - counts);
  bytes[8] = std::byte{1};
  EXPECT_EQ(sceneFromBytes(bytes).resolution, ResolutionChoice{});
}

TEST(SceneBytes, KeepMeshesBitForBit) {
  const HapticScene scene = richScene(), read = sceneFromBytes(toBytes(scene));
  const TriangleMesh &a = *scene.walls[8].shape.mesh, &b = *read.walls[8].shape.mesh;
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.closed, b.closed);
  EXPECT_EQ(b.tree.size(), b.blocks.size());
  EXPECT_EQ(read.zones[8].shape.mesh, read.walls[8].shape.mesh);  // shared, as it was
  EXPECT_EQ(read.zones[8].kind, Zone::Kind::rubberBand);
}

TEST(SceneBytes, WriteAMeshOnceForAllVersionsOfAScene) {
  HapticScene scene = richScene();
  SceneEncoder encoder;
  const std::vector<std::byte> first = encoder.encode(scene);
  ++scene.version;
  scene.walls[8].surface.stiffness = 77;
  const std::vector<std::byte> second = encoder.encode(scene);
  EXPECT_LT(second.size() + 500, first.size());
  scene.walls[8].shape.mesh = sphereSoup(0.5, 4).mesh();
  const std::vector<std::byte> third = encoder.encode(scene);
  EXPECT_GT(third.size(), second.size());

  SceneDecoder decoder;
  const HapticScene a = decoder.decode(first), b = decoder.decode(second), c = decoder.decode(third);
  EXPECT_EQ(a.walls[8].shape.mesh, b.walls[8].shape.mesh);
  EXPECT_EQ(b.walls[8].surface.stiffness, 77);
  EXPECT_EQ(c.walls[8].shape.mesh->vertices, scene.walls[8].shape.mesh->vertices);
  EXPECT_EQ(c.zones[8].shape.mesh, a.zones[8].shape.mesh);
  EXPECT_THAT(errorOf(second), HasSubstr("follows others"));
}

TEST(SceneBytes, RefuseMeshesThatAreNotSound) {
  HapticScene scene;
  scene.walls.resize(1);
  scene.walls[0].shape.kind = Shape::Kind::mesh;
  const std::vector<std::byte> none = toBytes(scene);
  EXPECT_EQ(sceneFromBytes(none).walls[0].shape.mesh, nullptr);
  scene.walls[0].shape.mesh = sphereSoup(0.5, 2).mesh();
  const std::vector<std::byte> bytes = toBytes(scene);
  const std::size_t mesh = toBytes({}).size() - 8;  // its first byte: the number of vertices
  const auto with = [&](std::size_t at, std::initializer_list<int> values) {
    std::vector<std::byte> damaged = bytes;
    for (const int value : values) damaged[at++] = static_cast<std::byte>(value);
    return errorOf(damaged);
  };
  EXPECT_THAT(with(mesh, {0xff, 0xff, 0xff, 0xff}), HasSubstr("entries announced"));
  EXPECT_THAT(with(mesh + 4 + 6, {0xf0, 0x7f}), HasSubstr("not finite"));
  EXPECT_THAT(with(mesh + 4 + 6, {0xe0, 0x7f}), HasSubstr("too far away"));
  const std::size_t triangles = mesh + 4 + 24 * scene.walls[0].shape.mesh->vertices.size();
  EXPECT_THAT(with(triangles + 4, {0xff, 0xff}), HasSubstr("vertices that are not there"));
  const std::size_t wall = triangles + 4 + 12 * scene.walls[0].shape.mesh->triangles.size() + 4;
  EXPECT_THAT(with(wall + 4 + 1 + 12 * 8, {1}), HasSubstr("a mesh that is not there"));
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
