#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTranslation.h>

#include "scenegraph/NodeRef.h"
#include "scenegraph/nodes/SoHapticNone.h"
#include "scenegraph/nodes/SoHapticSpringZone.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticTool.h"
#include "scenegraph/nodes/SoHapticViscousZone.h"
#include "tests/haptics/SameIndices.h"
#include "tests/scenegraph/SceneTesting.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using testing::read;
using testing::textOf;

/// A compiler that knows nothing of the compilation before but the ids and the meshes: it has met an error meanwhile.
class ForgetfulCompiler {
 public:
  CompiledScene compile(const SceneFile& file) {
    auto* second = new SoHapticTool;
    file.root->addChild(second);
    EXPECT_FALSE(compiler_.compile(file).scene);
    file.root->removeChild(second);
    return compiler_.compile(file);
  }

 private:
  SceneCompiler compiler_;
};

void expectShapeAsAnew(const Shape& a, const Shape& b) {
  ASSERT_EQ(a.kind, b.kind);
  ASSERT_EQ(a.centre, b.centre);
  ASSERT_EQ(a.axes, b.axes);
}

void expectOriginsAsAnew(const std::vector<ShapeOrigin>& a, const std::vector<ShapeOrigin>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].shape, b[i].shape);
    ASSERT_EQ(a[i].property, b[i].property);
  }
}

void expectSameWalls(const HapticScene& a, const HapticScene& b) {
  ASSERT_EQ(a.walls.size(), b.walls.size());
  for (std::size_t i = 0; i < a.walls.size(); ++i) {
    ASSERT_EQ(a.walls[i].id, b.walls[i].id);
    ASSERT_EQ(a.walls[i].surface.stiffness, b.walls[i].surface.stiffness);
    ASSERT_EQ(a.walls[i].surface.damping, b.walls[i].surface.damping);
    expectShapeAsAnew(a.walls[i].shape, b.walls[i].shape);
  }
}

void expectSameZones(const HapticScene& a, const HapticScene& b) {
  ASSERT_EQ(a.zones.size(), b.zones.size());
  for (std::size_t i = 0; i < a.zones.size(); ++i) {
    ASSERT_EQ(a.zones[i].id, b.zones[i].id);
    ASSERT_EQ(a.zones[i].kind, b.zones[i].kind);
    ASSERT_EQ(a.zones[i].damping, b.zones[i].damping);
    ASSERT_EQ(a.zones[i].anchor, b.zones[i].anchor);
    expectShapeAsAnew(a.zones[i].shape, b.zones[i].shape);
  }
}

void expectSame(const CompiledScene& a, const CompiledScene& b) {
  EXPECT_EQ(textOf(a.diagnostics), textOf(b.diagnostics));
  ASSERT_EQ(a.scene == nullptr, b.scene == nullptr);
  if (!a.scene) return;
  expectSameWalls(*a.scene, *b.scene);
  expectSameZones(*a.scene, *b.scene);
  expectOriginsAsAnew(a.origins.walls, b.origins.walls);
  expectOriginsAsAnew(a.origins.zones, b.origins.zones);
  EXPECT_EQ(a.origins.properties, b.origins.properties);
  EXPECT_EQ(a.origins.tool, b.origins.tool);
  testing::expectIndicesAsAnew(*a.scene);
}

/// A scene of many Separators, in groups within groups, some of them used twice, edited by chance.
class EditedGraph {
 public:
  explicit EditedGraph(std::uint64_t seed) : random_(seed), file_(read("HapticTool { home 9 9 9 }")) {
    groups_ = {file_.root.get()};
    for (int i = 0; i < 3; ++i) addGroup();
    for (int i = 0; i < 120; ++i) addWall();
  }

  void edit() {
    static constexpr void (EditedGraph::*kEdits[])() = {
        &EditedGraph::addWall,     &EditedGraph::addWall,       &EditedGraph::removeOne,  &EditedGraph::useAgain,
        &EditedGraph::moveOne,     &EditedGraph::moveOne,       &EditedGraph::stiffenOne, &EditedGraph::resizeOne,
        &EditedGraph::resizeOne,   &EditedGraph::shareProperty, &EditedGraph::makeWrong,  &EditedGraph::addPlace,
        &EditedGraph::addProperty, &EditedGraph::addGroup,      &EditedGraph::makeOdd,    &EditedGraph::silenceOne};
    (this->*kEdits[number(std::size(kEdits))])();
  }

  const SceneFile& file() const { return file_; }

 private:
  std::size_t number(std::size_t below) {
    return static_cast<std::size_t>(random_.between(0, static_cast<double>(below)));
  }
  float length() { return static_cast<float>(random_.between(0.01, 1)); }
  SbVec3f place() {
    const Vector3 p = random_.vector<Vector3>(-5, 5);
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }
  SoSeparator* anyGroup() { return groups_[number(groups_.size())]; }
  /// One of the Separators that hold shapes; it may stand nowhere any more.
  SoSeparator* anyWall() { return walls_[number(walls_.size())].get(); }
  template <typename Node>
  Node* in(SoSeparator* wall) {
    for (int i = 0; i < wall->getNumChildren(); ++i) {
      if (wall->getChild(i)->getTypeId() == Node::getClassTypeId()) return static_cast<Node*>(wall->getChild(i));
    }
    return nullptr;
  }
  void insert(SoNode* node, SoSeparator* group) {
    group->insertChild(node, static_cast<int>(number(static_cast<std::size_t>(group->getNumChildren()) + 1)));
  }

  void addGroup() {
    auto* group = new SoSeparator;
    insert(group, anyGroup());
    groups_.push_back(group);
  }
  void addWall() {
    auto* wall = new SoSeparator;
    if (number(4) > 0) wall->addChild(property());
    auto* translation = new SoTranslation;
    translation->translation = place();
    wall->addChild(translation);
    wall->addChild(new SoCube);
    if (number(4) == 0) {
      auto* zone = new SoHapticSpringZone;
      zone->anchor = place();
      wall->addChild(zone);
      wall->addChild(new SoSphere);
      wall->addChild(wall->getChild(wall->getNumChildren() - 3));  // the Cube, once more
    }
    walls_.emplace_back(wall);
    insert(wall, anyGroup());
  }
  SoNode* property() {
    if (number(5) == 0) return new SoHapticViscousZone;
    auto* surface = new SoHapticSurface;
    surface->stiffness = 1000 * length();
    return surface;
  }
  void removeOne() {
    SoSeparator* group = anyGroup();
    const int at = static_cast<int>(number(static_cast<std::size_t>(group->getNumChildren()) + 1)) - 1;
    if (at < 0) return;
    SoNode* child = group->getChild(at);
    const bool isGroup = std::ranges::find(groups_, child) != groups_.end();
    if (!isGroup && child->getTypeId() != SoHapticTool::getClassTypeId()) group->removeChild(at);
  }
  void useAgain() { insert(anyWall(), anyGroup()); }
  void moveOne() {
    if (auto* translation = in<SoTranslation>(anyWall())) translation->translation = place();
  }
  void stiffenOne() {
    if (auto* surface = in<SoHapticSurface>(anyWall())) surface->stiffness = 1000 * length();
  }
  void resizeOne() {
    if (auto* cube = in<SoCube>(anyWall())) cube->width = length();
  }
  void shareProperty() {
    if (auto* surface = in<SoHapticSurface>(anyWall())) anyWall()->insertChild(surface, 0);
  }
  /// Wrong, right, wrong again.
  void makeWrong() {
    auto* surface = in<SoHapticSurface>(anyWall());
    if (surface) surface->damping = surface->damping.getValue() < 0 ? 1.0F : -1.0F;
    if (surface && number(4) > 0) surface->damping = 2;
  }
  void addPlace() {
    auto* translation = new SoTranslation;
    translation->translation = place();
    insert(translation, anyGroup());
  }
  void addProperty() { insert(property(), anyGroup()); }
  /// No longer plain: Coin goes through it.
  void makeOdd() { anyWall()->insertChild(new SoGroup, 0); }
  void silenceOne() { anyWall()->insertChild(new SoHapticNone, 0); }

  test::Random random_;
  SceneFile file_;
  std::vector<SoSeparator*> groups_;
  std::vector<NodeRef<SoSeparator>> walls_;
};

TEST(EditedScenes, ComeToTheSameAsWhenEverythingIsCompiledAnew) {
  std::size_t valid = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    EditedGraph graph(seed);
    SceneCompiler compiler;
    ForgetfulCompiler anew;
    for (int version = 0; version < 60; ++version) {
      const CompiledScene compiled = compiler.compile(graph.file());
      valid += compiled.scene != nullptr;
      expectSame(compiled, anew.compile(graph.file()));
      if (::testing::Test::HasFailure()) FAIL() << "seed " << seed << ", version " << version;
      for (int edits = version % 5; edits >= 0; --edits) graph.edit();
    }
  }
  EXPECT_GT(valid, 100u);
}

}  // namespace
}  // namespace haptiv
