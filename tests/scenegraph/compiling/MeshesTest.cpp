// Shapes that are felt by their triangles.
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "scenegraph/compiling/SceneCollector.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using testing::read;
using testing::textOf;

// Coin's boxes are single precision, and so are its coordinates; the shapes here are about 1 m large.
constexpr double kFloat = 1e-5;

const std::string kSquare = "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } ";
const std::string kFaces = kSquare + "IndexedFaceSet { coordIndex [ 0, 1, 2, 3, -1 ] } ";

struct Felt {
  std::string name;
  std::string body;
  std::size_t walls = 1;
  bool isBoxLoose =
      false;  ///< Coin's box is larger than what it draws: room for the next letter, one grid cell too many
};
std::ostream& operator<<(std::ostream& out, const Felt& felt) {
  return out << felt.name;
}

class FeltByTriangles : public ::testing::TestWithParam<Felt> {};

SbBox3f boxOf(SoNode* root) {
  SoGetBoundingBoxAction action(SbViewportRegion(640, 480));
  action.apply(root);
  return action.getBoundingBox();
}

CompiledScene compile(SoSeparator* root) {
  return SceneCompiler().compile(root);
}

TEST_P(FeltByTriangles, FillsTheBoxInWhichCoinDrawsIt) {
  const SceneFile scene =
      read("HapticTool { home 1000 0 0 } Separator { HapticSurface { stiffness 7 } " + GetParam().body + " }");
  const CompiledScene compiled = compile(scene.root.get());
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  EXPECT_EQ(textOf(compiled.diagnostics), "");
  ASSERT_EQ(compiled.scene->walls.size(), GetParam().walls);
  ASSERT_EQ(compiled.origins.walls.size(), GetParam().walls);
  Vector3 low = Vector3::Constant(1e9), high = -low;
  for (const Wall& wall : compiled.scene->walls) {
    ASSERT_EQ(wall.shape.kind, Shape::Kind::mesh);
    ASSERT_TRUE(wall.shape.mesh);
    EXPECT_EQ(wall.surface.stiffness, 7);
    EXPECT_GT(wall.shape.mesh->triangles.size(), 0u);
    low = low.cwiseMin(wall.shape.centre - wall.shape.axes.diagonal());
    high = high.cwiseMax(wall.shape.centre + wall.shape.axes.diagonal());
  }
  const SbBox3f box = boxOf(scene.root.get());
  for (int i = 0; i < 3; ++i) {
    const double least = box.getMin()[i];
    const double most = box.getMax()[i];
    EXPECT_NEAR(low[i], least, kFloat);
    EXPECT_LE(high[i], most + kFloat);
    EXPECT_GE(high[i], GetParam().isBoxLoose ? (least + most) / 2 : most - kFloat);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, FeltByTriangles,
    ::testing::Values(
        Felt{"IndexedFaceSet", kFaces}, Felt{"FaceSet", kSquare + "FaceSet { numVertices 4 }"},
        Felt{"Concave",
             "ShapeHints { faceType UNKNOWN_FACE_TYPE } Coordinate3 { point [ 0 0 0, 1 0 0, 0.2 0.2 0, 0 1 0 ] } "
             "IndexedFaceSet { coordIndex [ 0, 1, 2, 3, -1 ] }"},
        Felt{"Strip", kSquare + "TriangleStripSet { numVertices 4 }"},
        Felt{"IndexedStrip", kSquare + "IndexedTriangleStripSet { coordIndex [ 0, 1, 3, 2, -1 ] }"},
        Felt{"QuadMesh", kSquare + "QuadMesh { verticesPerRow 2 verticesPerColumn 2 }"},
        Felt{"VertexProperty",
             "FaceSet { vertexProperty VertexProperty { vertex [ 0 0 0, 2 0 0, 2 1 1 ] } numVertices 3 }"},
        Felt{"Text3", "Font { size 1 } Text3 { string \"Haptiv\" parts ALL }", 1, true},
        Felt{"Array", "Array { numElements1 3 separation1 2 0 0 numElements2 2 separation2 0 0 2 " + kFaces + "}", 6},
        Felt{"MultipleCopy",
             "MultipleCopy { matrix [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1, 1 0 0 0 0 1 0 0 0 0 1 0 5 0 0 1 ] " + kFaces +
                 "}",
             2},
        Felt{"UsedTwice",
             "Separator { Scale { scaleFactor 2 1 1 } DEF F Group { " + kFaces +
                 "} } Separator { Rotation { rotation 1 2 3 0.5 } USE F }",
             2},
        Felt{"Switch", "Switch { whichChild 1 Cube { } Group { " + kFaces + "} }"},
        Felt{"Perspective", "MatrixTransform { matrix 1 0 0 0.1 0 1 0 0 0 0 1 0 0 0 0 1 } " + kFaces},
        Felt{"Flat", "Cube { depth 0 }"}, Felt{"OpenCone", "Cone { parts SIDES }"},
        Felt{"Nurbs",
             "Coordinate3 { point [ 0 0 0, 1 0 0, 0 1 0, 1 1 1 ] } NurbsSurface { numUControlPoints 2 "
             "numVControlPoints 2 "
             "uKnotVector [ 0, 0, 1, 1 ] vKnotVector [ 0, 0, 1, 1 ] }"},
        Felt{"IndexedNurbs",
             "Coordinate3 { point [ 9 9 9, 1 1 1, 0 1 0, 1 0 0, 0 0 0 ] } IndexedNurbsSurface { numUControlPoints 2 "
             "numVControlPoints 2 coordIndex [ 4, 3, 2, 1 ] uKnotVector [ 0, 0, 1, 1 ] vKnotVector [ 0, 0, 1, 1 ] }"},
        Felt{"VrmlFaces",
             "VRMLTransform { translation 0 0 3 children VRMLShape { geometry VRMLIndexedFaceSet { coord "
             "VRMLCoordinate { "
             "point [ 0 0 0, 1 0 0, 1 1 1 ] } coordIndex [ 0, 1, 2, -1 ] } } }"},
        Felt{"VrmlGrid",
             "VRMLShape { geometry VRMLElevationGrid { xDimension 2 zDimension 2 height [ 0 0.1 0.2 0.3 ] } }", 1,
             true}),
    [](const auto& one) { return one.param.name; });

// Their boxes in Coin are not those of their triangles: of the ideal shape, or of the coarser drawing.
TEST(FeltByTriangles, HasRoundShapesThatATransformBendsAsFinelyAsCoinCuts) {
  for (const std::string body : {"Scale { scaleFactor 1 2 1 } Sphere { }", "Scale { scaleFactor 1 1 2 } Cylinder { }",
                                 "Scale { scaleFactor 1 1 2 } VRMLShape { geometry VRMLSphere { } }",
                                 "VRMLShape { geometry VRMLCylinder { top FALSE } }"}) {
    const SceneFile scene = read("HapticTool { home 1000 0 0 } HapticSurface { } " + body);
    const CompiledScene compiled = compile(scene.root.get());
    ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
    ASSERT_EQ(compiled.scene->walls.size(), 1u) << body;
    ASSERT_TRUE(compiled.scene->walls[0].shape.mesh) << body;
    // A corner of an inscribed polygon with n sides is 1 - cos(pi / n) within the circle: 1 % at 22 sides.
    const Vector3 half = compiled.scene->walls[0].shape.axes.diagonal();
    EXPECT_NEAR(half.maxCoeff(), body.find("top") == std::string::npos ? 2 : 1, 0.02) << body;
  }
}

TEST(FeltByTriangles, TakesTheFinestLevelOfDetail) {
  const std::string two = "Group { " + kFaces + "} Cube { } ";
  for (const std::string& body :
       {"LOD { center 500 0 0 range [ 1 ] " + two + "}", "LOD { range [ 0 ] " + two + "}",
        "LevelOfDetail { screenArea [ 1e9, 1 ] " + two + "}",
        "VRMLLOD { center 500 0 0 range [ 1 ] level [ Group { " + kFaces + "}, Cube { } ] }"}) {
    const SceneFile scene = read("HapticTool { home 1000 0 0 } HapticSurface { } " + body);
    const CompiledScene compiled = compile(scene.root.get());
    ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
    ASSERT_EQ(compiled.scene->walls.size(), 1u) << body;
    EXPECT_EQ(compiled.scene->walls[0].shape.kind, Shape::Kind::mesh) << body;
  }
}

Vector3 normalOf(const std::string& body) {
  const SceneFile scene = read("HapticTool { home 1000 0 0 } HapticSurface { } " + body);
  const CompiledScene compiled = compile(scene.root.get());
  if (!compiled.scene || compiled.scene->walls.empty()) return Vector3::Zero();
  const TriangleMesh& mesh = *compiled.scene->walls[0].shape.mesh;
  return (mesh.corner(0, 1) - mesh.corner(0, 0)).cross(mesh.corner(0, 2) - mesh.corner(0, 0)).normalized();
}

TEST(FeltByTriangles, FacesTheSideFromWhichItsCornersGoRoundToTheLeft) {
  EXPECT_TRUE(normalOf(kFaces).isApprox(Vector3::UnitZ()));
  EXPECT_TRUE(normalOf("Scale { scaleFactor -1 1 1 } " + kFaces).isApprox(Vector3::UnitZ())) << "mirrored";
  EXPECT_TRUE(normalOf("ShapeHints { vertexOrdering CLOCKWISE } " + kFaces).isApprox(-Vector3::UnitZ()));
}

TEST(FeltByTriangles, LeavesOutWhatHasNoFaces) {
  for (const std::string& body :
       {kSquare + "LineSet { numVertices 4 }", kSquare + "PointSet { }", "Scale { scaleFactor 0 0 1 } " + kFaces}) {
    const SceneFile scene = read("HapticTool { home 1000 0 0 }\nHapticSurface { } " + body);
    const CompiledScene compiled = SceneCompiler().compile(scene.root.get(), scene.lineOf, scene.path);
    ASSERT_TRUE(compiled.scene);
    EXPECT_TRUE(compiled.scene->walls.empty());
    EXPECT_THAT(textOf(compiled.diagnostics), HasSubstr("test.iv:3: warning")) << body;
  }
}

TEST(FeltByTriangles, SaysWhichShapeIsTooMuch) {
  const SceneFile scene =
      read("HapticTool { } HapticSurface { } Array { numElements1 3 " + kFaces + "} DEF last Cube { depth 0 }");
  for (const std::size_t most : {5u, 6u, 100u}) {
    SceneMemory memory;
    SceneCollector collector(memory, {}, most);
    collector.collect(scene.root.get());
    EXPECT_EQ(hasErrors(collector.diagnostics), most < 100);
    if (most < 100) {
      EXPECT_THAT(textOf(collector.diagnostics), HasSubstr("beyond " + std::to_string(most) + " triangles"));
    }
    EXPECT_EQ(textOf(collector.diagnostics).find("\"last\"") != std::string::npos, most == 6);
  }
}

TEST(FeltByTriangles, TellsHowFarALongCompilationHasCome) {
  for (const int copies : {3, 100}) {
    const SceneFile scene =
        read("HapticTool { home 1000 0 0 } HapticSurface { } Array { numElements1 " + std::to_string(copies) +
             " numElements2 " + std::to_string(copies) + " " + kFaces + "}");
    SceneCompiler compiler;
    std::vector<std::size_t> told;
    compiler.setProgress([&](std::size_t shapes, std::size_t) { told.push_back(shapes); });
    compiler.compile(scene.root.get());
    EXPECT_EQ(told.empty(), copies < 100);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  }
}

TEST(FeltByTriangles, InheritsPropertiesDownAVrmlGraph) {
  const SceneFile scene = readSceneText(
      "#VRML V2.0 utf8\nHapticTool { home 1000 0 0 }\nTransform { translation 1 0 0 children [ HapticSurface { "
      "stiffness 9 } "
      "Group { children Shape { geometry Box { size 1 2 3 } } } Shape { geometry Sphere { radius 2 } } ] }\n"
      "Shape { geometry Cone { } }\nTransform { children [ HapticViscousZone { } Shape { geometry Cylinder { } } ] }\n",
      "test.wrl");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  const CompiledScene compiled = compile(scene.root.get());
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  ASSERT_EQ(compiled.scene->walls.size(), 2u);
  EXPECT_EQ(compiled.scene->walls[0].surface.stiffness, 9);
  EXPECT_EQ(compiled.scene->walls[0].shape.kind, Shape::Kind::box);
  EXPECT_TRUE(compiled.scene->walls[0].shape.axes.diagonal().isApprox(Vector3(0.5, 1, 1.5)));
  EXPECT_EQ(compiled.scene->walls[1].shape.kind, Shape::Kind::sphere);
  ASSERT_EQ(compiled.scene->zones.size(), 1u);
  EXPECT_EQ(compiled.scene->zones[0].shape.kind, Shape::Kind::cylinder);
}

/// A quarter of a cylinder of radius 1, as a rational spline: its corners are on the cylinder, its faces hardly inside.
TEST(FeltByTriangles, HasNurbsAsFinelyAsCoinCuts) {
  const SceneFile scene = read(
      "HapticTool { home 1000 0 0 } HapticSurface { } Coordinate4 { point [ 1 0 0 1, 0.70710678 0.70710678 0 "
      "0.70710678, "
      "0 1 0 1, 1 0 1 1, 0.70710678 0.70710678 0.70710678 0.70710678, 0 1 1 1 ] } "
      "DEF N NurbsSurface { numUControlPoints 3 numVControlPoints 2 uKnotVector [ 0, 0, 0, 1, 1, 1 ] "
      "vKnotVector [ 0, 0, 1, 1 ] }");
  SceneCompiler compiler;
  const CompiledScene compiled = compiler.compile(scene.root.get());
  ASSERT_TRUE(compiled.scene) << textOf(compiled.diagnostics);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  const TriangleMesh& mesh = *compiled.scene->walls[0].shape.mesh;
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    Vector3 middle = Vector3::Zero();
    for (const auto corner : triangle) {
      const Vector3& p = mesh.vertices[corner];
      EXPECT_NEAR(p.head<2>().norm(), 1, kFloat);
      middle += p / 3;
    }
    EXPECT_GT(middle.head<2>().norm(), 0.998);
  }
}

TEST(FeltByTriangles, HasNurbsAnewWhereTheirPointsHaveChanged) {
  const SceneFile scene = read(
      "HapticTool { home 1000 0 0 } HapticSurface { } DEF P Coordinate3 { point [ 0 0 0, 1 0 0, 0 1 0, 1 1 0 ] } "
      "NurbsSurface { numUControlPoints 2 numVControlPoints 2 uKnotVector [ 0, 0, 1, 1 ] vKnotVector [ 0, 0, 1, 1 ] }");
  SceneCompiler compiler;
  const auto before = compiler.compile(scene.root.get()).scene;
  static_cast<SoCoordinate3*>(SoNode::getByName("P"))->point.set1Value(3, 1, 1, 2);
  const auto after = compiler.compile(scene.root.get()).scene;
  ASSERT_TRUE(before && after);
  EXPECT_EQ(before->walls[0].shape.mesh->bounds.high.z(), 0);
  EXPECT_EQ(after->walls[0].shape.mesh->bounds.high.z(), 2);
}

}  // namespace
}  // namespace haptiv
