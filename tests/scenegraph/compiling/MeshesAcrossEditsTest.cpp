#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoTransform.h>
#include <gtest/gtest.h>

#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using testing::read;

class MeshesAcrossEdits : public ::testing::Test {
 protected:
  MeshesAcrossEdits()
      : scene_(read("HapticTool { home 1000 0 0 } HapticSurface { } Separator { DEF T Transform { } "
                    "DEF C Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } IndexedFaceSet { coordIndex [ 0, 1, 2, "
                    "3, -1 ] } } DEF B Cube { }")) {}

  const TriangleMesh* compileMesh() {
    scenes_.push_back(compiler_.compile(scene_.root.get()).scene);  // no address is used again
    return scenes_.back() ? scenes_.back()->walls.front().shape.mesh.get() : nullptr;
  }
  template <typename Node>
  Node* named(const char* name) {
    return static_cast<Node*>(SoNode::getByName(name));
  }

  SceneFile scene_;
  SceneCompiler compiler_;
  std::vector<std::shared_ptr<const HapticScene>> scenes_;
};

TEST_F(MeshesAcrossEdits, AreKeptWhereNothingOfTheirsHasChanged) {
  const TriangleMesh* first = compileMesh();
  ASSERT_TRUE(first);
  EXPECT_EQ(compileMesh(), first);
  named<SoCube>("B")->width = 0.5F;
  EXPECT_EQ(compileMesh(), first) << "another shape was changed";
}

TEST_F(MeshesAcrossEdits, AreMadeAnewWhereTheirPointsOrPlaceHaveChanged) {
  const TriangleMesh* first = compileMesh();
  named<SoCoordinate3>("C")->point.set1Value(2, 1, 1, 1);
  const TriangleMesh* second = compileMesh();
  EXPECT_NE(second, first);
  EXPECT_EQ(second->bounds.high.z(), 1);
  named<SoTransform>("T")->translation.setValue(0, 0, 2);
  const TriangleMesh* third = compileMesh();
  EXPECT_NE(third, second);
  EXPECT_EQ(third->bounds.high.z(), 3);
}

}  // namespace
}  // namespace haptiv
