#include "scenegraph/solid/MakeSolid.h"

#include <gmock/gmock.h>

#include "scenegraph/judging/SceneJudge.h"
#include "scenegraph/solid/SolidModel.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using testing::read;
using testing::textOf;

void insert(SceneFile& scene, const DeviceDescription& device) {
  const auto nodes = solidNodes(scene.root.get(), device);
  for (std::size_t i = 0; i < nodes.size(); ++i) scene.root->insertChild(nodes[i].get(), static_cast<int>(i));
}

class Solid : public ::testing::TestWithParam<double> {};

TEST_P(Solid, CanBeFeltAtAnySizeAndPlace) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  const std::string s = std::to_string(GetParam());
  SceneFile scene = read("Scale { scaleFactor " + s + " " + s + " " + s +
                         " } Translation { translation 3 -7 5 } Cube { } Translation { translation 2 1 1 } Sphere { }");
  insert(scene, device);
  const CompiledScene compiled = SceneCompiler().compile(scene.root.get());
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  EXPECT_EQ(compiled.scene->walls.size(), 2u);
  EXPECT_EQ(textOf(judgeScene({*compiled.scene, compiled.origins, device})), "");
  // What the hand feels is the same at any size.
  const double scale = compiled.scene->device.scale;
  EXPECT_NEAR(scale * compiled.scene->tool.mass, 2, 1e-5);
  EXPECT_NEAR(scale * compiled.scene->walls[0].surface.stiffness, 20000, 0.1);
  EXPECT_NEAR(compiled.scene->tool.radius, 0.08 * GetParam(), 1e-5 * GetParam()) << "a fiftieth of 4 m";
}

INSTANTIATE_TEST_SUITE_P(Sizes, Solid, ::testing::Values(0.001, 0.05, 1.0, 1000.0));

TEST(MakeSolid, FindsNoBallForWhatHasNoSize) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  for (const char* body : {"Coordinate3 { point 1 2 3 } PointSet { }", "Scale { scaleFactor 1e20 1e20 1e20 } Cube { }",
                           "Switch { Cube { } }"}) {
    const SceneFile scene = read(body);
    EXPECT_NE(solidFault(modelBounds(scene.root.get())), "") << body;
    EXPECT_TRUE(solidNodes(scene.root.get(), device).empty()) << body;
  }
}

TEST(MakeSolid, KnowsWhichLengthsAreNegative) {
  const SceneFile scene =
      read("Cube { width -1 height 2 depth -3 } Switch { Cone { bottomRadius -2 } } Sphere { } Cylinder { height -1 }");
  std::vector<float> found;
  for (const NegativeSize& size : negativeSizes(scene.root.get())) found.push_back(size.field->getValue());
  EXPECT_THAT(found, ::testing::ElementsAre(-1, -3, -2, -1));
}

TEST(MakeSolid, AddsOnlyWhatLacks) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  const auto count = [&](const std::string& body) { return solidNodes(read(body).root.get(), device).size(); };
  EXPECT_EQ(count("Cube { }"), 3u);
  EXPECT_EQ(count("HapticTool { } Cube { }"), 2u);
  EXPECT_EQ(count("HapticDevice { } HapticTool { } Cube { }"), 1u);
  EXPECT_EQ(count("HapticDevice { } HapticTool { } HapticSurface { } Cube { }"), 0u);
  EXPECT_EQ(count("Material { }"), 0u) << "nothing to be felt";
}

}  // namespace
}  // namespace haptiv
