#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <fstream>

#include "app/generate/MazeScene.h"
#include "app/generate/ReliefScene.h"
#include "app/generate/SceneText.h"
#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/judging/SceneJudge.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {
namespace {

class GeneratedScene : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { initSceneGraph(); }

  static std::string shipped(const std::string& name) {
    std::ifstream in(std::string(HAPTIV_SOURCE_DIR) + "/scenes/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// Compiles it; everything that is said of it comes to stand in `remarks`.
  CompiledScene compile(const std::string& text) {
    file_ = readSceneText(text, "generated.iv");
    EXPECT_TRUE(file_.root);
    CompiledScene compiled = file_.root ? SceneCompiler().compile(file_.root.get()) : CompiledScene();
    for (const Diagnostic& one : compiled.diagnostics) remarks += toText(one) + "\n";
    if (compiled.scene) {
      for (const Diagnostic& one : judgeScene({*compiled.scene, compiled.origins, loadDeviceDescription("vishard10")}))
        remarks += toText(one) + "\n";
    }
    return compiled;
  }

  std::string remarks;

 private:
  SceneFile file_;
};

TEST_F(GeneratedScene, HasAWallForEachOfTheMaze) {
  for (const auto& [columns, rows] : {std::pair{2, 2}, {3, 20}, {30, 7}}) {
    const CompiledScene compiled = compile(MazeScene(Maze(columns, rows, 5), 5).text());
    ASSERT_TRUE(compiled.scene);
    EXPECT_EQ(remarks, "");
    EXPECT_EQ(compiled.scene->walls.size(),
              static_cast<std::size_t>((columns - 1) * (rows - 1) + 2 * (columns + rows)));
    EXPECT_EQ(compiled.scene->zones.size(), 1u);
  }
}

TEST_F(GeneratedScene, IsTheMazeThatIsShipped) {
  // Not EXPECT_EQ: half a megabyte is nothing to print.
  EXPECT_TRUE(MazeScene(Maze(100, 100, 1), 1).text() == shipped("maze.iv"));
}

TEST_F(GeneratedScene, IsAnIslandOfTwoTrianglesForEachCell) {
  const CompiledScene compiled = compile(reliefScene(40, 30, 2));
  ASSERT_TRUE(compiled.scene);
  EXPECT_EQ(remarks, "");
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  ASSERT_TRUE(compiled.scene->walls[0].shape.mesh);
  const TriangleMesh& mesh = *compiled.scene->walls[0].shape.mesh;
  EXPECT_EQ(mesh.triangles.size(), 2u * 40 * 30);
  EXPECT_EQ(mesh.vertices.size(), 41u * 31);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vector3 normal = (mesh.corner(i, 1) - mesh.corner(i, 0)).cross(mesh.corner(i, 2) - mesh.corner(i, 0));
    ASSERT_GT(normal.z(), 0) << "it is seen from above";
  }
}

TEST_F(GeneratedScene, WritesNumbersAsShortAsTheyCanBe) {
  EXPECT_EQ(sceneNumbers({0.1, -0.0, 2, 1 / 3.0, -1e-9, 12345.678901}), "0.1 0 2 0.33333 0 12345.6789");
}

}  // namespace
}  // namespace haptiv
