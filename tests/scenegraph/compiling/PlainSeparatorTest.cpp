#include "scenegraph/compiling/PlainSeparator.h"

#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

#include <random>

#include "scenegraph/nodes/SoHapticSurface.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using testing::read;
using testing::textOf;

/// What may stand in a Separator, with numbers by chance.
class Dice {
 public:
  explicit Dice(unsigned seed) : chance_(seed) {}

  std::string separator(const std::string& first) {
    std::string text = "Separator { " + first;
    for (int i = number(1, 7); i > 0; --i) text += node();
    return text + "}\n";
  }
  std::string node() {
    switch (number(0, 13)) {
      case 0:
        return "HapticSurface { stiffness " + any(1, 9000) + "damping " + any(0, 50) + "} ";
      case 1:
        return "HapticSpringZone { anchor " + place() + "} ";
      case 2:
        return "HapticRubberBand { restLength 0.1 anchor " + place() + "} ";
      case 3:
        return number(0, 1) ? "HapticNone { } " : "HapticViscousZone { damping " + any(0, 50) + "} ";
      case 4:
        return "Material { diffuseColor 1 0 0 } ";
      case 5:
        return "Translation { translation " + place() + "} ";
      case 6:
        return "Rotation { rotation " + place() + any(-3, 3) + "} ";
      case 7:
        return "Scale { scaleFactor 1 " + any(0.5, 2) + "1 } ";
      case 8:
        return "Transform { translation " + place() + "rotation 1 2 3 " + any(-3, 3) + "center " + place() +
               "scaleFactor 2 2 2 scaleOrientation 0 1 1 " + any(-3, 3) + "} ";
      case 9:
        return "Sphere { radius " + any(0.1, 2) + "} ";
      case 10:
        return "Cylinder { radius " + any(0.1, 2) + "} ";
      case 11:
        return "Cone { } Group { } ";  // which is not plain
      default:
        return "Cube { width " + any(0.1, 2) + "} ";
    }
  }

 private:
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(chance_); }
  std::string any(double low, double high) {
    return std::to_string(std::uniform_real_distribution<double>(low, high)(chance_)) + " ";
  }
  std::string place() { return any(-1, 1) + any(-1, 1) + any(-1, 1); }

  std::mt19937 chance_;
};

/// A scene of Separators that begin with so much.
CompiledScene compiledFrom(unsigned seed, const std::string& first) {
  Dice dice(seed);
  std::string body = "HapticTool { home 9 9 9 } Rotation { rotation 1 2 3 0.3 } HapticSurface { stiffness 77 }\n";
  for (int i = 0; i < 40; ++i) body += dice.separator(first);
  const SceneFile file = read(body);
  return SceneCompiler().compile(file.root.get(), file.lineOf, file.path);
}

void expectSameShape(const Shape& a, const Shape& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.centre, b.centre);
  EXPECT_EQ(a.axes, b.axes);
}

/// A Group is not plain: Coin goes through the whole Separator then.
TEST(PlainSeparator, ComesToTheSameBitForBitAsWhenCoinGoesThroughIt) {
  std::size_t shapes = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const CompiledScene plain = compiledFrom(seed, "");
    const CompiledScene coin = compiledFrom(seed, "Group { } ");
    EXPECT_EQ(textOf(plain.diagnostics), textOf(coin.diagnostics));
    ASSERT_TRUE(plain.scene && coin.scene) << textOf(plain.diagnostics);
    ASSERT_EQ(plain.scene->walls.size(), coin.scene->walls.size());
    for (std::size_t i = 0; i < plain.scene->walls.size(); ++i) {
      const Wall &a = plain.scene->walls[i], &b = coin.scene->walls[i];
      EXPECT_EQ(a.id, b.id);
      expectSameShape(a.shape, b.shape);
      EXPECT_EQ(a.surface.stiffness, b.surface.stiffness);
      EXPECT_EQ(a.surface.damping, b.surface.damping);
    }
    ASSERT_EQ(plain.scene->zones.size(), coin.scene->zones.size());
    for (std::size_t i = 0; i < plain.scene->zones.size(); ++i) {
      const Zone &a = plain.scene->zones[i], &b = coin.scene->zones[i];
      EXPECT_EQ(a.id, b.id);
      EXPECT_EQ(a.kind, b.kind);
      expectSameShape(a.shape, b.shape);
      EXPECT_EQ(a.anchor, b.anchor);
    }
    EXPECT_EQ(plain.origins.properties.size(), coin.origins.properties.size());
    shapes += plain.scene->walls.size() + plain.scene->zones.size();
  }
  EXPECT_GT(shapes, 1000u);
}

TEST(PlainSeparator, KeepsTheIdsOfItsShapesWhenItCeasesToBePlain) {
  const SceneFile file =
      read("HapticTool { home 9 9 9 } HapticSurface { } Separator { Cube { } } Separator { Cube { } Sphere { } }");
  SceneCompiler compiler;
  const auto before = compiler.compile(file).scene;
  static_cast<SoSeparator*>(file.root->getChild(3))->insertChild(new SoGroup, 1);
  const auto after = compiler.compile(file).scene;
  ASSERT_EQ(after->walls.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(after->walls[i].id, before->walls[i].id);
}

/// The index of the version before is taken over where the shapes are the same, and nowhere else.
TEST(PlainSeparator, IsFoundByTheServoWhereAnEditHasPutIt) {
  const SceneFile file = read(
      "HapticTool { home 9 9 9 } Separator { HapticSurface { } Translation { } Cube { } } "
      "Separator { HapticSurface { } Translation { translation 3 0 0 } Sphere { } }");
  auto* wall = static_cast<SoSeparator*>(file.root->getChild(1));
  SceneCompiler compiler;
  compiler.compile(file);
  const auto edit = [&](int number) {
    if (number == 0) static_cast<SoHapticSurface*>(wall->getChild(0))->stiffness = 5;
    if (number == 1) static_cast<SoTranslation*>(wall->getChild(1))->translation.setValue(0, 7, 0);
    if (number == 2) file.root->removeChild(2);
  };
  for (int number = 0; number < 3; ++number) {
    edit(number);
    const auto scene = compiler.compile(file).scene;
    HapticScene anew = *scene;
    computeBounds(anew);
    EXPECT_EQ(scene->wallIndex.byId, anew.wallIndex.byId);
    ASSERT_EQ(scene->wallIndex.entries.size(), anew.wallIndex.entries.size());
    for (const Wall& each : scene->walls) {
      int found = 0;
      scene->wallIndex.tree.forEachNear(each.shape.centre, 0.01, [&](std::uint32_t) { ++found; });
      EXPECT_EQ(found, 1);
    }
  }
}

}  // namespace
}  // namespace haptiv
