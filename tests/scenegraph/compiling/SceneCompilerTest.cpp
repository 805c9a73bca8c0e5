#include "scenegraph/compiling/SceneCompiler.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>
#include <gmock/gmock.h>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using testing::compile;
using ::testing::HasSubstr;
using testing::read;
using testing::textOf;

constexpr double kSinglePrecision = 1e-6;  // Coin's matrices are single precision; the scenes here are about 1 m large

TEST(SceneCompiler, PutsTheCornersOfATurnedAndStretchedCubeWhereCoinPutsThem) {
  const CompiledScene compiled = compile(
      "HapticSurface { } Transform { translation 0.1 -0.2 0.3 rotation 1 2 3 0.7 scaleFactor 0.5 2 1.5 "
      "scaleOrientation 0 1 1 0.4 } Cube { width 0.2 height 0.4 depth 0.6 }");
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  const Shape& shape = compiled.scene->walls[0].shape;

  SbMatrix matrix;
  matrix.setTransform(SbVec3f(0.1F, -0.2F, 0.3F), SbRotation(SbVec3f(1, 2, 3), 0.7F), SbVec3f(0.5F, 2, 1.5F),
                      SbRotation(SbVec3f(0, 1, 1), 0.4F));
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 s(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    SbVec3f expected;
    matrix.multVecMatrix(SbVec3f(0.1F * float(s[0]), 0.2F * float(s[1]), 0.3F * float(s[2])), expected);
    const Vector3 actual = shape.centre + shape.axes * s;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], kSinglePrecision) << "corner " << corner;
  }
}

TEST(SceneCompiler, MakesTwoWallsOfOneCubeUsedUnderTwoTransforms) {
  const CompiledScene compiled = compile(
      "HapticSurface { } Separator { Translation { translation 1 0 0 } DEF C Cube { } } "
      "Separator { Translation { translation 0 5 0 } USE C }");
  ASSERT_TRUE(compiled.scene);
  ASSERT_EQ(compiled.scene->walls.size(), 2u);
  EXPECT_TRUE(compiled.scene->walls[0].shape.centre.isApprox(Vector3(1, 0, 0)));
  EXPECT_TRUE(compiled.scene->walls[1].shape.centre.isApprox(Vector3(0, 5, 0)));
  EXPECT_NE(compiled.scene->walls[0].id, compiled.scene->walls[1].id);
}

TEST(SceneCompiler, MakesAWallOfEveryElementOfAnArray) {
  const CompiledScene compiled =
      compile("HapticSurface { } Array { numElements1 3 separation1 4 0 0 numElements2 2 separation2 0 4 0 Cube { } }");
  ASSERT_TRUE(compiled.scene);
  ASSERT_EQ(compiled.scene->walls.size(), 6u);
  EXPECT_TRUE(compiled.scene->walls[5].shape.centre.isApprox(Vector3(8, 4, 0)));
}

TEST(SceneCompiler, ScalesTheRadiusOfASphere) {
  const CompiledScene compiled = compile("HapticSurface { } Scale { scaleFactor 3 3 3 } Sphere { radius 0.5 }");
  ASSERT_TRUE(compiled.scene);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  EXPECT_EQ(compiled.scene->walls[0].shape.kind, Shape::Kind::sphere);
  EXPECT_NEAR(compiled.scene->walls[0].shape.axes.col(0).norm(), 1.5, kSinglePrecision);
}

TEST(SceneCompiler, KeepsCylindersAndConesUnderRotationAndAxialScale) {
  for (const std::string keyword : {"Cylinder", "Cone"}) {
    const CompiledScene compiled = compile(
        "HapticSurface { } Rotation { rotation 1 1 0 0.5 } Scale { scaleFactor 2 5 2 } " + keyword + " { height 0.2 }");
    ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
    ASSERT_EQ(compiled.scene->walls.size(), 1u) << textOf(compiled.diagnostics);
    const Matrix3& axes = compiled.scene->walls[0].shape.axes;
    EXPECT_NEAR(axes.col(0).norm(), 2, kSinglePrecision);
    EXPECT_NEAR(axes.col(1).norm(), 0.5, kSinglePrecision);
    EXPECT_NEAR(axes.col(2).norm(), 2, kSinglePrecision);
    EXPECT_NEAR(axes.col(0).dot(axes.col(1)), 0, 1e-12);  // straightened in double precision
  }
}

struct Remark {
  std::string body;
  std::string expected;
};
class RemarkOfCompiler : public ::testing::TestWithParam<Remark> {};

TEST_P(RemarkOfCompiler, NamesLineNodeAndRemedy) {
  const CompiledScene compiled = compile("\n" + GetParam().body);
  EXPECT_THAT(textOf(compiled.diagnostics), HasSubstr(GetParam().expected));
  EXPECT_EQ(compiled.diagnostics.size(), 1u) << textOf(compiled.diagnostics);
  EXPECT_EQ(!compiled.scene, hasErrors(compiled.diagnostics));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, RemarkOfCompiler,
    ::testing::Values(Remark{"HapticSurface { } Cube { width -1 }",
                             "error: Cube: width is -1: write a positive length"},
                      Remark{"HapticSurface { stiffness -5 label \"door\" }",
                             "test.iv:3: error: HapticSurface \"door\": stiffness is -5: write 0 or more N/m"},
                      Remark{"HapticSurface { damping -1 }", "damping is -1"},
                      Remark{"HapticSurface { staticFriction 0.2 dynamicFriction 0.5 }",
                             "warning: HapticSurface: dynamicFriction is 0.5, above staticFriction, which is 0.2"},
                      Remark{"HapticViscousZone { damping -2 }", "error: HapticViscousZone: damping is -2"},
                      Remark{"HapticSpringZone { restLength -1 }", "error: HapticSpringZone: restLength is -1"},
                      Remark{"HapticTool { }", "error: HapticTool: is a second tool"},
                      Remark{"HapticDevice { scale 0 }", "error: HapticDevice: scale is 0: write more than 0"},
                      Remark{"HapticDevice { description \"\" }", "description is empty"},
                      Remark{"Translation { translation 1 0 0 } HapticDevice { }",
                             "warning: HapticDevice: stands after a transform"}));

TEST(SceneCompiler, AsksForATool) {
  const SceneFile scene = read("Cube { }");
  const CompiledScene compiled = SceneCompiler().compile(scene.root.get(), scene.lineOf, scene.path);
  EXPECT_FALSE(compiled.scene);
  EXPECT_THAT(textOf(compiled.diagnostics), HasSubstr("add HapticTool"));
}

TEST(SceneCompiler, RefusesAToolThatCannotBe) {
  const SceneFile scene = read("HapticTool { mass 0 radius -1 damping -1 }");
  const CompiledScene compiled = SceneCompiler().compile(scene.root.get(), scene.lineOf, scene.path);
  EXPECT_FALSE(compiled.scene);
  EXPECT_EQ(compiled.diagnostics.size(), 3u) << textOf(compiled.diagnostics);
}

TEST(SceneCompiler, LeavesOutWhatIsNotToBeFelt) {
  const CompiledScene compiled = compile(
      "Cube { } Separator { HapticSurface { } } Sphere { } HapticSurface { enabled FALSE } Cube { } "
      "HapticSurface { } HapticNone { } Cone { } Switch { HapticSurface { } Cube { } }");
  ASSERT_TRUE(compiled.scene);
  EXPECT_EQ(compiled.scene->walls.size() + compiled.scene->zones.size(), 0u);
  EXPECT_EQ(textOf(compiled.diagnostics), "");
}

TEST(SceneCompiler, GivesAShapeThePropertyBeforeItUntilTheSeparatorEnds) {
  const CompiledScene compiled = compile(
      "HapticSurface { stiffness 1 } Separator { Cube { } HapticSurface { stiffness 2 } Cube { } } Cube { } "
      "Group { HapticViscousZone { damping 3 } } Cube { }");
  ASSERT_TRUE(compiled.scene);
  ASSERT_EQ(compiled.scene->walls.size(), 3u);
  EXPECT_EQ(compiled.scene->walls[0].surface.stiffness, 1);
  EXPECT_EQ(compiled.scene->walls[1].surface.stiffness, 2);
  EXPECT_EQ(compiled.scene->walls[2].surface.stiffness, 1);
  ASSERT_EQ(compiled.scene->zones.size(), 1u);  // a Group does not restore what was before it
  EXPECT_EQ(compiled.scene->zones[0].damping, 3);
}

TEST(SceneCompiler, MovesTheAnchorOfASpringWithItsRegion) {
  const CompiledScene compiled = compile(
      "HapticSpringZone { anchor 1 0 0 restLength 0.1 } Translation { translation 0 2 0 } Scale { scaleFactor 3 1 1 } "
      "Cube { }");
  ASSERT_TRUE(compiled.scene);
  ASSERT_EQ(compiled.scene->zones.size(), 1u);
  EXPECT_TRUE(compiled.scene->zones[0].anchor.isApprox(Vector3(3, 2, 0)));
  EXPECT_FLOAT_EQ(compiled.scene->zones[0].restLength, 0.1F);
}

TEST(SceneCompiler, SeesAHandleAsTheTransformThatItStandsFor) {
  const CompiledScene compiled = compile("HapticSurface { } HandleBoxManip { translation 0 0 4 } Cube { }");
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  EXPECT_TRUE(compiled.scene->walls[0].shape.centre.isApprox(Vector3(0, 0, 4)));
}

TEST(SceneCompiler, KeepsTheIdOfAWallThroughEdits) {
  const SceneFile scene = read(
      "HapticTool { home 9 9 9 } HapticSurface { } Separator { DEF t Transform { } Cube { } } Separator { Sphere { } "
      "}");
  SceneCompiler compiler;
  const auto first = compiler.compile(scene.root.get()).scene;
  ASSERT_TRUE(first);
  ASSERT_EQ(first->walls.size(), 2u);
  EXPECT_EQ(first->walls[0].id, 1u);
  EXPECT_EQ(first->walls[1].id, 2u);

  static_cast<SoTransform*>(SoNode::getByName("t"))->translation.setValue(0, 0, 3);
  scene.root->insertChild(new SoCube, 2);
  const auto second = compiler.compile(scene.root.get()).scene;
  ASSERT_TRUE(second);
  ASSERT_EQ(second->walls.size(), 3u);
  EXPECT_EQ(second->walls[0].id, 3u);  // the new one
  EXPECT_EQ(second->walls[1].id, 1u);
  EXPECT_EQ(second->walls[2].id, 2u);
  EXPECT_EQ(first->version + 1, second->version);
}

TEST(SceneCompiler, CountsTheTrianglesThatAreDrawn) {
  const SceneFile scene = read("Cube { } Switch { Cube { } } Array { numElements1 3 Cube { } }");
  EXPECT_EQ(drawnTriangles(scene.root.get()), 4u * 12u);
}

TEST(SceneCompiler, CarriesTheBoundsThatTheServoLooksThingsUpBy) {
  const CompiledScene compiled = compile("HapticSurface { } Cube { } HapticViscousZone { } Cube { }");
  ASSERT_TRUE(compiled.scene);
  EXPECT_EQ(compiled.scene->wallIndex.tree.size(), 1u);
  EXPECT_EQ(compiled.scene->zoneIndex.tree.size(), 1u);
}

}  // namespace
}  // namespace haptiv
