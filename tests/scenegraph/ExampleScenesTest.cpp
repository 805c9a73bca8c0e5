#include <gmock/gmock.h>

#include "haptics/scene/HapticScene.h"
#include "scenegraph/GraphWalk.h"
#include "scenegraph/judging/SceneJudge.h"
#include "scenegraph/writing/SceneSaver.h"
#include "scenegraph/writing/SceneWriter.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using testing::compile;
using testing::scenesIn;
using testing::sourceDir;
using testing::textOf;

// Coin writes floats with 8 digits: enough for a relative 6e-8, and a product of a few matrices stays within 1e-6.
constexpr double kRounding = 1e-6;

void expectEqual(const Shape& a, const Shape& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_LE((a.centre - b.centre).cwiseAbs().maxCoeff(), kRounding);
  EXPECT_LE((a.axes - b.axes).cwiseAbs().maxCoeff(), kRounding);
  ASSERT_EQ(a.mesh == nullptr, b.mesh == nullptr);
  if (!a.mesh) return;
  EXPECT_EQ(a.mesh->vertices.size(), b.mesh->vertices.size());
  EXPECT_TRUE(a.mesh->triangles == b.mesh->triangles);
}

void expectEqual(const HapticScene& a, const HapticScene& b) {
  EXPECT_NEAR(a.tool.mass, b.tool.mass, kRounding);
  EXPECT_NEAR(a.tool.damping, b.tool.damping, kRounding);
  EXPECT_NEAR(a.tool.radius, b.tool.radius, kRounding);
  EXPECT_LE((a.tool.home - b.tool.home).norm(), kRounding);
  EXPECT_EQ(a.device.description, b.device.description);
  EXPECT_LE((a.device.position - b.device.position).norm(), kRounding);
  EXPECT_LE((a.device.rotation - b.device.rotation).norm(), kRounding);
  EXPECT_NEAR(a.device.scale, b.device.scale, kRounding);
  ASSERT_EQ(a.walls.size(), b.walls.size());
  for (std::size_t i = 0; i < a.walls.size(); ++i) {
    EXPECT_EQ(a.walls[i].id, b.walls[i].id);
    EXPECT_FLOAT_EQ(a.walls[i].surface.stiffness, b.walls[i].surface.stiffness);
    EXPECT_FLOAT_EQ(a.walls[i].surface.damping, b.walls[i].surface.damping);
    expectEqual(a.walls[i].shape, b.walls[i].shape);
  }
  ASSERT_EQ(a.zones.size(), b.zones.size());
  for (std::size_t i = 0; i < a.zones.size(); ++i) {
    EXPECT_EQ(a.zones[i].kind, b.zones[i].kind);
    EXPECT_FLOAT_EQ(a.zones[i].damping, b.zones[i].damping);
    EXPECT_FLOAT_EQ(a.zones[i].stiffness, b.zones[i].stiffness);
    EXPECT_FLOAT_EQ(a.zones[i].restLength, b.zones[i].restLength);
    EXPECT_LE((a.zones[i].anchor - b.zones[i].anchor).norm(), kRounding);
    expectEqual(a.zones[i].shape, b.zones[i].shape);
  }
}

class ExampleScene : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(ExampleScene, LoadsAndCompilesWithoutARemark) {
  const SceneFile scene = readScene(GetParam());
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  const CompiledScene compiled = SceneCompiler().compile(scene);
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  const DeviceDescription device = loadDeviceDescription(compiled.scene->device.description);
  const Diagnostics judgement = judgeScene({*compiled.scene, compiled.origins, device});
  EXPECT_EQ(textOf(scene.diagnostics) + textOf(compiled.diagnostics) + textOf(judgement), "");
  EXPECT_GT(compiled.scene->walls.size() + compiled.scene->zones.size(), 0u);
  EXPECT_GT(drawnTriangles(scene.root.get()), 0u);
}

TEST_P(ExampleScene, IsTheSameAfterSavingAndOpening) {
  const testing::ScratchFolder folder;
  const SceneFile first = readScene(GetParam());
  ASSERT_TRUE(first.root) << textOf(first.diagnostics);
  saveScene(first.root.get(), folder.path() / "again.iv");
  const SceneFile second = readScene(folder.path() / "again.iv");
  ASSERT_TRUE(second.root) << textOf(second.diagnostics);
  EXPECT_EQ(writeSceneText(first.root.get()), writeSceneText(second.root.get()));

  const CompiledScene before = SceneCompiler().compile(first.root.get());
  const CompiledScene after = SceneCompiler().compile(second.root.get());
  ASSERT_TRUE(before.scene && after.scene);
  EXPECT_EQ(drawnTriangles(first.root.get()), drawnTriangles(second.root.get()));
  expectEqual(*before.scene, *after.scene);
}

INSTANTIATE_TEST_SUITE_P(Shipped, ExampleScene, ::testing::ValuesIn(scenesIn(sourceDir() / "scenes")),
                         testing::nameOfFile);

TEST(LabyrinthScene, HasTheWallsAndZonesOfThePaper) {
  const SceneFile scene = readScene(sourceDir() / "scenes/labyrinth.iv");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  const CompiledScene compiled = SceneCompiler().compile(scene.root.get());
  ASSERT_TRUE(compiled.scene);
  EXPECT_EQ(compiled.scene->walls.size(), 10u);
  ASSERT_EQ(compiled.scene->zones.size(), 2u);
  EXPECT_EQ(compiled.scene->zones[0].kind, Zone::Kind::viscous);
  EXPECT_EQ(compiled.scene->zones[1].kind, Zone::Kind::spring);
}

TEST(SpringBench, HasTwoSpringsAndABand) {
  const SceneFile scene = readScene(sourceDir() / "scenes/spring-bench.iv");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  const CompiledScene compiled = SceneCompiler().compile(scene.root.get());
  ASSERT_TRUE(compiled.scene);
  ASSERT_EQ(compiled.scene->zones.size(), 3u);
  EXPECT_EQ(compiled.scene->zones[1].kind, Zone::Kind::spring);
  EXPECT_EQ(compiled.scene->zones[2].kind, Zone::Kind::rubberBand);
  EXPECT_FLOAT_EQ(compiled.scene->zones[2].restLength, 0.04F);
}

}  // namespace
}  // namespace haptiv
