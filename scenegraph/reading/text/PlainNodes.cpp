#include "scenegraph/reading/text/PlainNodes.h"

#include <algorithm>
#include <array>

namespace haptiv {
namespace {

constexpr std::array<std::string_view, 56> kPlain = {
    // Inventor
    "Separator", "Group", "Switch", "Transform", "Translation", "Rotation", "RotationXYZ", "Scale", "MatrixTransform",
    "Material", "MaterialBinding", "BaseColor", "Normal", "NormalBinding", "Coordinate3", "VertexProperty", "Cube",
    "Sphere", "Cone", "Cylinder", "IndexedFaceSet", "FaceSet", "IndexedLineSet", "LineSet", "PointSet",
    "IndexedTriangleStripSet", "TriangleStripSet", "QuadMesh", "DirectionalLight", "PointLight", "SpotLight",
    "PerspectiveCamera", "OrthographicCamera", "DrawStyle", "ShapeHints", "Info", "Label", "LightModel", "Units",
    "Environment", "PackedColor",
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
