#include "app/view/drawn/GroundGrid.h"

#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace haptiv {
namespace {

constexpr float kSpacing = 0.05F;  // [m]
constexpr int kLines = 20;         // to each side of the origin
constexpr float kReach = kSpacing * kLines;
constexpr float kBelowFloor = -0.0005F;

struct Lines {
  std::vector<SbVec3f> points;
  std::vector<std::uint32_t> colors;
  std::vector<std::int32_t> lengths;
};

// Colour and, fading outwards, opacity as Coin packs them: 0xrrggbbaa.
std::uint32_t colorAt(const SbVec3f& point, bool strong) {
  const float nearness = std::clamp(1 - std::hypot(point[0], point[1]) / kReach, 0.0F, 1.0F);
  const float opacity = (strong ? 0.42F : 0.2F) * std::min(1.0F, 1.8F * nearness);
  return 0x56687C00U | static_cast<std::uint32_t>(std::lround(255 * opacity));
}

void addLine(Lines& lines, int index, bool alongX) {
  const float across = kSpacing * static_cast<float>(index);
  for (int i = -kLines; i <= kLines; ++i) {
    const float along = kSpacing * static_cast<float>(i);
    const SbVec3f point = alongX ? SbVec3f(along, across, kBelowFloor) : SbVec3f(across, along, kBelowFloor);
    lines.points.push_back(point);
    lines.colors.push_back(colorAt(point, index % 2 == 0));
  }
  lines.lengths.push_back(2 * kLines + 1);
}

SoLineSet* makeLines() {
  Lines lines;
  for (int i = -kLines; i <= kLines; ++i) {
    addLine(lines, i, true);
    addLine(lines, i, false);
  }
  auto* vertices = new SoVertexProperty;
  vertices->vertex.setValues(0, static_cast<int>(lines.points.size()), lines.points.data());
  vertices->orderedRGBA.setValues(0, static_cast<int>(lines.colors.size()), lines.colors.data());
  vertices->materialBinding = SoMaterialBinding::PER_VERTEX;
  auto* set = new SoLineSet;
  set->vertexProperty = vertices;
  set->numVertices.setValues(0, static_cast<int>(lines.lengths.size()), lines.lengths.data());
  return set;
}

}  // namespace

SoSeparator* makeGroundGrid() {
  auto* root = new SoSeparator;
  auto* notPicked = new SoPickStyle;
  notPicked->style = SoPickStyle::UNPICKABLE;
  auto* flat = new SoLightModel;
  flat->model = SoLightModel::BASE_COLOR;
  auto* thin = new SoDrawStyle;
  thin->lineWidth = 1;
  for (SoNode* node : std::initializer_list<SoNode*>{notPicked, flat, thin, makeLines()}) root->addChild(node);
  return root;
}

}  // namespace haptiv
