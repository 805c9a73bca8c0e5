#include "scenegraph/reading/text/PlainNodes.h"

#include <algorithm>
#include <array>

namespace haptiv {
namespace {

// Not FaceSet and TriangleStripSet: for many of their vertices in one place Coin takes a time that grows with the
// square.
constexpr std::array<std::string_view, 54> kPlain = {
    // Inventor
    "Separator", "Group", "Switch", "Transform", "Translation", "Rotation", "RotationXYZ", "Scale", "MatrixTransform",
    "Material", "MaterialBinding", "BaseColor", "Normal", "NormalBinding", "Coordinate3", "VertexProperty", "Cube",
    "Sphere", "Cone", "Cylinder", "IndexedFaceSet", "IndexedLineSet", "LineSet", "PointSet", "IndexedTriangleStripSet",
    "QuadMesh", "DirectionalLight", "PointLight", "SpotLight", "PerspectiveCamera", "OrthographicCamera", "DrawStyle",
    "ShapeHints", "Info", "Label", "LightModel", "Units", "Environment", "PackedColor",
    // VRML97
    "Shape", "Appearance", "Box", "Coordinate", "Color", "Viewpoint", "NavigationInfo", "WorldInfo",
    // Haptiv
    "HapticTool", "HapticDevice", "HapticSurface", "HapticNone", "HapticViscousZone", "HapticSpringZone",
    "HapticRubberBand"};

}  // namespace

bool isPlainNode(std::string_view keyword) {
  return std::ranges::find(kPlain, keyword) != kPlain.end();
}

}  // namespace haptiv
