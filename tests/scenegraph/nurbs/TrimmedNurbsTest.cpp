#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoSwitch.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "scenegraph/isolation/Isolated.h"
#include "scenegraph/solid/MakeSolid.h"
#include "scenegraph/solid/SolidModel.h"
#include "scenegraph/writing/SceneSaver.h"
#include "scenegraph/writing/SceneWriter.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using testing::compile;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::read;
using testing::textOf;
using testing::trianglesOf;

constexpr double kGlu = 1e-5;  // of what GLU computes in single precision, about 1 in size

/// A square of 1 m, each way with its parameters from 0 to 1 along x and y.
const std::string kSquareMetre = "Coordinate3 { point [ 0 0 0, 1 0 0, 0 1 0, 1 1 0 ] } ";
/// All of it, but for a square hole of 0.3 m in its middle.
const std::string kWithHole =
    "ProfileCoordinate2 { point [ 0 0, 1 0, 1 1, 0 1, 0.35 0.35, 0.35 0.65, 0.65 0.65, 0.65 0.35 ] } "
    "LinearProfile { index [ 0, 1, 2, 3, 0 ] } LinearProfile { index [ 4, 5, 6, 7, 4 ] linkage START_NEW } ";
const std::string kSurface =
    "NurbsSurface { numUControlPoints 2 numVControlPoints 2 uKnotVector [ 0, 0, 1, 1 ] vKnotVector [ 0, 0, 1, 1 ] } ";

double areaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 from = mesh.vertices[a];
    area += (mesh.vertices[b] - from).cross(mesh.vertices[c] - from).norm() / 2;
  }
  return area;
}

/// Of a mesh, seen from above.
bool covers(const TriangleMesh& mesh, double x, double y) {
  const auto side = [&](const Vector3& a, const Vector3& b) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  return std::ranges::any_of(mesh.triangles, [&](const TriangleMesh::Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const auto& corners = mesh.vertices;
    const double sides[] = {side(corners[a], corners[b]), side(corners[b], corners[c]), side(corners[c], corners[a])};
    return std::ranges::all_of(sides, [](double s) { return s >= 0; }) ||
           std::ranges::all_of(sides, [](double s) { return s <= 0; });
  });
}

TEST(TrimmedNurbs, AreFeltBesideAHoleAndNotInIt) {
  const CompiledScene compiled = compile("HapticSurface { } " + kSquareMetre + kWithHole + kSurface);
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  const TriangleMesh& mesh = *compiled.scene->walls[0].shape.mesh;
  EXPECT_NEAR(areaOf(mesh), 1 - 0.3 * 0.3, kGlu);
  for (const double x : {0.1, 0.34, 0.36, 0.5, 0.64, 0.66, 0.9}) {
    for (const double y : {0.1, 0.34, 0.36, 0.5, 0.64, 0.66, 0.9}) {
      const bool isInHole = std::abs(x - 0.5) < 0.15 && std::abs(y - 0.5) < 0.15;
      EXPECT_NE(covers(mesh, x, y), isInHole) << x << " " << y;
    }
  }
}

TEST(TrimmedNurbs, FollowCurvesOfSeveralProfiles) {
  const CompiledScene compiled = compile(
      "HapticSurface { } " + kSquareMetre +
      "ProfileCoordinate3 { point [ 0.2 0.2 1, 0.8 0.2 1, 0.8 0.5 1, 0.5656854 0.5656854 0.70710678, 0.5 0.8 1 ] } "
      "LinearProfile { index [ 4, 0, 1, 2 ] } "
      "NurbsProfile { index [ 2, 3, 4 ] knotVector [ 0, 0, 0, 1, 1, 1 ] linkage ADD_TO_CURRENT } " +
      kSurface);
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  const TriangleMesh& mesh = *compiled.scene->walls[0].shape.mesh;
  EXPECT_TRUE(covers(mesh, 0.3, 0.3));
  EXPECT_FALSE(covers(mesh, 0.75, 0.75));
}

TEST(TrimmedNurbs, AreSolidWhereAModelIsMadeSo) {
  const SceneFile scene = read(kSquareMetre + kWithHole + kSurface);
  const DeviceDescription device = loadDeviceDescription("vishard10");
  for (const NodeRef<>& node : solidNodes(scene.root.get(), device)) scene.root->insertChild(node.get(), 0);
  const CompiledScene compiled = SceneCompiler().compile(scene);
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  EXPECT_NEAR(areaOf(*compiled.scene->walls[0].shape.mesh), 1 - 0.3 * 0.3, kGlu);
}

TEST(TrimmedNurbs, AreAsLargeAsWhatIsLeftOfThem) {
  const SceneFile scene = read(kSquareMetre +
                               "ProfileCoordinate2 { point [ 0.25 0.25, 0.5 0.25, 0.5 0.5, 0.25 0.5 ] } "
                               "LinearProfile { index [ 0, 1, 2, 3, 0 ] } " +
                               kSurface);
  const SbBox3f box = modelBounds(scene.root.get());
  EXPECT_TRUE(box.getMin().equals({0.25F, 0.25F, 0}, 1e-5F));
  EXPECT_TRUE(box.getMax().equals({0.5F, 0.5F, 0}, 1e-5F));
}

TEST(TrimmedNurbs, AreSavedAsTheyWereWritten) {
  const SceneFile scene =
      read(kSquareMetre + kWithHole + "DEF N " + kSurface + "Translation { } USE N VRMLShape { geometry USE N }");
  const std::string text = writeSceneText(scene.root.get());
  EXPECT_THAT(text, HasSubstr("DEF N NurbsSurface"));
  EXPECT_THAT(text, HasSubstr("LinearProfile"));
  for (const char* added : {"Switch", "Faces", "Complexity"}) EXPECT_THAT(text, Not(HasSubstr(added)));
  const SceneFile again = readSceneText(text, "again.iv");
  ASSERT_TRUE(again.root) << textOf(again.diagnostics);
  EXPECT_EQ(writeSceneText(again.root.get()), text);
  EXPECT_EQ(trianglesOf(again), trianglesOf(scene));
}

TEST(TrimmedNurbs, AreSavedWhereAPrototypeMakesThem) {
  const SceneFile scene = readSceneText("#VRML V2.0 utf8\nPROTO P [ ] { Group { children [ " + kSquareMetre +
                                            kWithHole + kSurface + "] } }\nP { } P { }\n",
                                        "test.wrl");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  EXPECT_GT(trianglesOf(scene), 0);
  const testing::ScratchFolder folder;
  saveScene(scene.root.get(), folder.path() / "saved.iv");
  const SceneFile again = readScene(folder.path() / "saved.iv");
  ASSERT_TRUE(again.root) << textOf(again.diagnostics);
  EXPECT_EQ(trianglesOf(again), trianglesOf(scene));
}

TEST(TrimmedNurbs, AreCutForEachPlaceByWhatIsInForceThere) {
  const CompiledScene compiled =
      compile("HapticSurface { } " + kSquareMetre + "DEF N " + kSurface + "Separator { " + kWithHole +
              "USE N } Separator { " + kWithHole +
              "Coordinate3 { point [ 0 0 0, 2 0 0, 0 2 0, 2 2 0 ] } USE N } Translation { translation 5 0 0 } USE N");
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  std::vector<double> areas;
  for (const Wall& wall : compiled.scene->walls) areas.push_back(areaOf(*wall.shape.mesh));
  ASSERT_EQ(areas.size(), 4u);
  const double expected[] = {1, 0.91, 4 * 0.91, 1};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(areas[i], expected[i], 4 * kGlu) << i;
}

TEST(TrimmedNurbs, AreCutBehindASwitchToo) {
  const SceneFile scene = read(kSquareMetre + kWithHole + "DEF S Switch { " + kSurface + "}");
  EXPECT_EQ(trianglesOf(scene), 0);
  static_cast<SoSwitch*>(SoNode::getByName("S"))->whichChild = 0;
  EXPECT_GT(trianglesOf(scene), 0);
}

TEST(TrimmedNurbs, AreCutAnewWhereTheyAreCopiedOrChanged) {
  const SceneFile scene = read("HapticTool { home 1000 0 0 } HapticSurface { } DEF U Separator { " + kSquareMetre +
                               kWithHole + kSurface + "}");
  auto* unit = static_cast<SoSeparator*>(SoNode::getByName("U"));
  const NodeRef<SoNode> copy(unit->copy());
  auto* points = static_cast<SoCoordinate3*>(static_cast<SoSeparator*>(copy.get())->getChild(0));
  scene.root->addChild(copy.get());
  SceneCompiler compiler;
  for (const double height : {0.0, 2.0}) {
    points->point.set1Value(3, 1, 1, static_cast<float>(height));
    const CompiledScene compiled = compiler.compile(scene);
    ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
    ASSERT_EQ(compiled.scene->walls.size(), 2u);
    EXPECT_EQ(compiled.scene->walls[0].shape.mesh->bounds.high.z(), 0);
    EXPECT_NEAR(compiled.scene->walls[1].shape.mesh->bounds.high.z(), height, kGlu);
  }
}

/// Of three, the second is one on which GLU crashes (a profile of no points), or does not end (a loop that is not
/// closed, on a certain surface).
TEST(TrimmedNurbs, AreLeftOutWithAWarningWhereGluCrashesOrDoesNotEnd) {
  const std::string crash = "LinearProfile { index [ ] } DEF bad " + kSurface;
  const std::string endless =
      "Coordinate3 { point [ 0 0 0.0671821, 0.333333 0 0.423717, 0.666667 0 0.381887, 1 0 0.127535, "
      "0 0.333333 0.247718, 0.333333 0.333333 0.224746, 0.666667 0.333333 0.325796, 1 0.333333 0.394362, "
      "0 0.666667 0.0469298, 0.333333 0.666667 0.0141737, 0.666667 0.666667 0.417883, 1 0.666667 0.216384, "
      "0 1 0.38114, 0.333333 1 0.00105303, 0.666667 1 0.222694, 1 1 0.36077 ] } "
      "ProfileCoordinate2 { point [ 0.277672 0.37885, 0.559374 0.959804, 0.528363 0.579083 ] } "
      "LinearProfile { index [ 0, 1, 2 ] } DEF bad NurbsSurface { numUControlPoints 4 numVControlPoints 4 "
      "uKnotVector [ 0, 0, 0, 0, 1, 1, 1, 1 ] vKnotVector [ 0, 0, 0, 0, 1, 1, 1, 1 ] }";
  const std::string good = "Separator { " + kSquareMetre + kWithHole + kSurface + "}\n";
  for (const std::string& bad : {crash, endless}) {
    const SceneFile scene = read("HapticTool { home 1000 0 0 } HapticSurface { }\n" + good + "Separator { " +
                                 kSquareMetre + bad + "}\n" + good);
    ASSERT_EQ(scene.diagnostics.size(), 1u) << textOf(scene.diagnostics);
    EXPECT_EQ(scene.diagnostics[0].severity, Diagnostic::Severity::warning);
    EXPECT_EQ(scene.diagnostics[0].line, 4);
    EXPECT_EQ(scene.diagnostics[0].node, "NurbsSurface \"bad\"");
    EXPECT_THAT(scene.diagnostics[0].message, HasSubstr("is neither shown nor felt where profiles trim it"));
    const CompiledScene compiled = SceneCompiler().compile(scene);
    ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
    EXPECT_EQ(compiled.scene->walls.size(), 2u);
    EXPECT_THAT(writeSceneText(scene.root.get()), HasSubstr("DEF bad NurbsSurface"));
  }
}

TEST(TrimmedNurbs, AreNothingWhereTooManyProfilesTrimThem) {
  std::string profiles;
  for (int i = 0; i < 1001; ++i) profiles += "LinearProfile { index [ 0, 1, 2, 3, 0 ] linkage START_NEW } ";
  const SceneFile scene = read(kSquareMetre + kWithHole + profiles + kSurface + kSurface);
  ASSERT_EQ(scene.diagnostics.size(), 2u) << textOf(scene.diagnostics);
  for (const Diagnostic& warning : scene.diagnostics)
    EXPECT_THAT(warning.message, HasSubstr("is neither shown nor felt where profiles trim it"));
  EXPECT_EQ(trianglesOf(scene), 0);
}

TEST(TrimmedNurbs, AreCoarserWhereThereAreMany) {
  const std::string curved =
      "Coordinate3 { point [ 0 0 0, 1 0 0, 2 0 0, 0 1 0, 1 1 1, 2 1 0, 0 2 0, 1 2 0, 2 2 0 ] } " + kWithHole;
  const auto trianglesEach = [&](int count) {
    std::string body = curved;
    for (int i = 0; i < count; ++i) {
      body +=
          "NurbsSurface { numUControlPoints 3 numVControlPoints 3 uKnotVector [ 0, 0, 0, 1, 1, 1 ] "
          "vKnotVector [ 0, 0, 0, 1, 1, 1 ] }\n";
    }
    const SceneFile scene = read(body);
    EXPECT_TRUE(scene.diagnostics.empty()) << textOf(scene.diagnostics);
    return trianglesOf(scene) / count;
  };
  const int few = trianglesEach(1);
  EXPECT_GT(few, 1000);
  EXPECT_LT(trianglesEach(501), few / 10);
}

/// What is tried there has GLU, which no process without files could load.
TEST(Nurbs, AreCutInAProcessOfItsOwn) {
  const SceneFile scene = read(kSquareMetre + kSurface);
  const Isolated cut = runIsolated([&] { return std::to_string(trianglesOf(scene)); });
  EXPECT_EQ(cut.fault, "");
  EXPECT_EQ(cut.result, std::to_string(trianglesOf(scene)));
  EXPECT_NE(cut.result, "0");
}

TEST(Nurbs, AreDrawnAsCurvesBesideProfiles) {
  const SceneFile scene =
      read(kSquareMetre + kWithHole + "NurbsCurve { numControlPoints 4 knotVector [ 0, 0, 0, 0, 1, 1, 1, 1 ] }");
  EXPECT_TRUE(scene.diagnostics.empty()) << textOf(scene.diagnostics);
  EXPECT_FALSE(modelBounds(scene.root.get()).isEmpty());
}

}  // namespace
}  // namespace haptiv
