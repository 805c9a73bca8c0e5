#include "scenegraph/nurbs/TrimmedPlace.h"

#include <Inventor/elements/SoCoordinateElement.h>
#include <Inventor/elements/SoProfileCoordinateElement.h>
#include <Inventor/elements/SoProfileElement.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCoordinate4.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoNurbsSurface.h>
#include <Inventor/nodes/SoProfile.h>
#include <Inventor/nodes/SoProfileCoordinate2.h>
#include <Inventor/nodes/SoProfileCoordinate3.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTexture2.h>

#include <cstddef>

namespace haptiv {
namespace {

constexpr int kMostProfiles = 1000;

template <typename Point>
std::span<const Point> listed(const Point* first, int count) {
  return {first, first ? static_cast<std::size_t>(count) : 0};
}

/// A node that holds them.
template <typename Node, typename Points>
SoNode* holding(const Points& points) {
  auto* node = new Node;
  node->point.setValues(0, static_cast<int>(points.size()), points.data());
  return node;
}

/// Any: without one in force, Coin gives corners no place on a texture.
SoNode* anyTexture() {
  static constexpr unsigned char kGrey = 0x80;
  auto* texture = new SoTexture2;
  texture->image.setValue({1, 1}, 1, &kGrey);
  return texture;
}

/// The surface without what the program has made of it: a node made by `new` is Coin's.
SoNode* plainCopy(const SoNode* surface) {
  SoNode* copy = new SoNurbsSurface;
  if (surface->isOfType(SoIndexedNurbsSurface::getClassTypeId())) copy = new SoIndexedNurbsSurface;
  copy->copyFieldValues(surface);
  return copy;
}

}  // namespace

std::optional<TrimmedPlace> TrimmedPlace::of(const SoNode* surface, SoState* state) {
  if (!state->isElementEnabled(SoProfileElement::getClassStackIndex())) return {};
  const SoNodeList& profiles = SoProfileElement::get(state);
  const int count = profiles.getLength();
  if (count == 0) return {};
  TrimmedPlace place;
  place.surface_ = surface;
  if (count > kMostProfiles) return place;
  const auto* points = SoCoordinateElement::getInstance(state);
  const auto* profilePoints = SoProfileCoordinateElement::getInstance(state);
  place.key_ = {surface->getNodeId(), points->getNodeId(), profilePoints->getNodeId()};
  for (int i = 0; i < count; ++i) {
    place.profiles_.push_back(profiles[i]);
    place.key_.push_back(profiles[i]->getNodeId());
  }
  if (points->is3D()) {
    place.points_ = listed(points->getArrayPtr3(), points->getNum());
  } else {
    place.points_ = listed(points->getArrayPtr4(), points->getNum());
  }
  if (profilePoints->is2D()) {
    place.profilePoints_ = listed(profilePoints->getArrayPtr2(), profilePoints->getNum());
  } else {
    place.profilePoints_ = listed(profilePoints->getArrayPtr3(), profilePoints->getNum());
  }
  return place;
}

NodeRef<SoSeparator> TrimmedPlace::graph(float fineness) const {
  NodeRef<SoSeparator> root(new SoSeparator);
  auto* complexity = new SoComplexity;
  complexity->type = SoComplexity::OBJECT_SPACE;
  complexity->value = fineness;
  root->addChild(complexity);
  root->addChild(anyTexture());
  const bool isRational = points_.index() == 1;
  root->addChild(isRational ? holding<SoCoordinate4>(std::get<1>(points_))
                            : holding<SoCoordinate3>(std::get<0>(points_)));
  const bool isFlat = profilePoints_.index() == 0;
  root->addChild(isFlat ? holding<SoProfileCoordinate2>(std::get<0>(profilePoints_))
                        : holding<SoProfileCoordinate3>(std::get<1>(profilePoints_)));
  for (SoNode* profile : profiles_) root->addChild(profile);
  root->addChild(plainCopy(surface_));
  return root;
}

}  // namespace haptiv
