#include "app/editor/edits/ShapeFrame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/edits/Edits.h"
#include "tests/app/editor/EditedScene.h"

namespace haptiv {
namespace {

constexpr double kSingleChain = 1e-5;  // single precision through a chain of matrices

const char kNested[] = R"(#Inventor V2.1 ascii
Separator {
  HapticTool { }
  HapticSurface { }
  Transform { translation 0.2 0.1 0 rotation 0 0 1 0.7 scaleFactor 2 2 2 }
  Separator {
    Transform { translation 0.05 0 0 rotation 0 0 1 0.2 scaleFactor 1 2 1 center 0.01 0.02 0 }
    DEF Box Cube { width 0.02 height 0.03 depth 0.04 }
  }
  Separator { Transform { } DEF Ball Sphere { radius 0.02 } }
  Separator { Transform { translation 0 0 1 } DEF Post Cylinder { radius 0.02 height 0.1 } }
})";

ShapeFrame frameOf(EditedScene& scene, const QString& name) {
  EXPECT_TRUE(scene.select(name));
  return ShapeFrame::of(*scene.document.selection()).value();
}

TEST(ShapeFrame, ReadsWhatTheCompilerReads) {
  EditedScene scene(kNested);
  const ShapeFrame frame = frameOf(scene, "Box");
  const Shape& shape = scene.document.compiled().scene->walls[0].shape;
  EXPECT_TRUE(frame.centre().isApprox(shape.centre, kSingleChain));
  EXPECT_TRUE(frame.size().isApprox(Vector3(2 * shape.axes.colwise().norm().transpose()), kSingleChain));
  EXPECT_NEAR(frame.yaw(), 0.9, kSingleChain);
}

TEST(ShapeFrame, PutsTheShapeWhereItIsTold) {
  EditedScene scene(kNested);
  ASSERT_TRUE(scene.select("Box"));
  moveShape(
      scene.document,
      [](ShapeFrame& frame) {
        frame.setYaw(-0.4);
        frame.setSize({0.3, 0.2, 0.1});
        frame.setCentre({0.5, -0.5, 0.25});
      },
      "move");
  letEventsRun();
  const Shape& shape = scene.document.compiled().scene->walls[0].shape;
  EXPECT_TRUE(shape.centre.isApprox(Vector3(0.5, -0.5, 0.25), kSingleChain));
  EXPECT_TRUE(Vector3(2 * shape.axes.colwise().norm().transpose()).isApprox(Vector3(0.3, 0.2, 0.1), kSingleChain));
  EXPECT_NEAR(std::atan2(shape.axes(1, 0), shape.axes(0, 0)), -0.4, kSingleChain);
}

TEST(ShapeFrame, KeepsRoundThingsRound) {
  EditedScene scene(kNested);
  for (const QString name : {"Ball", "Post"}) {
    ASSERT_TRUE(scene.select(name));
    moveShape(
        scene.document,
        [](ShapeFrame& frame) {
          Vector3 size = frame.size();
          size.z() = 0.3;
          frame.setSize(size);
        },
        "resizing");
  }
  letEventsRun();
  EXPECT_FALSE(hasErrors(scene.document.diagnostics()));
  EXPECT_TRUE(frameOf(scene, "Ball").size().isApprox(Vector3(0.3, 0.3, 0.3), kSingleChain));
  EXPECT_TRUE(frameOf(scene, "Post").size().isApprox(Vector3(0.3, 0.2, 0.3), kSingleChain));
}

TEST(ShapeFrame, NeverGetsThinnerThanAWallCanBe) {
  EditedScene scene(kNested);
  ShapeFrame frame = frameOf(scene, "Box");
  frame.setSize({0, -1, 0.5});
  EXPECT_TRUE(frame.size().isApprox(Vector3(0.005, 0.005, 0.5), kSingleChain));
  EXPECT_GT(frame.value().scaleFactor[0], 0);
}

}  // namespace
}  // namespace haptiv
