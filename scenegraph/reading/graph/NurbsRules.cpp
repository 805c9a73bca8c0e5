#include "scenegraph/reading/graph/NurbsRules.h"

#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/nodes/SoIndexedNurbsCurve.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoNurbsCurve.h>
#include <Inventor/nodes/SoNurbsSurface.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace haptiv {
namespace {

constexpr std::int64_t kMostOrder = 24;      // of GLU
constexpr std::int64_t kMostPatches = 2000;  // some four million triangles at the finest

/// One direction of a spline.
class Spline {
 public:
  Spline(std::string name, int points, const SoMFFloat& knots)
      : name_(std::move(name)),
        points_(points),
        count_(knots.getNum()),
        knot_(knots.getValues(0)),
        order_(count_ - points_) {}

  std::int64_t points() const { return points_; }
  std::int64_t pieces() const { return points_ - order_ + 1; }
  bool isUsed() const { return points_ != 0; }

  std::string fault() const {
    if (points_ < 2)
      return "has " + std::to_string(points_) + " control points along " + name_ + ": it takes 2 or more";
    if (order_ < 2 || order_ > kMostOrder || order_ > points_) {
      return "has " + std::to_string(count_) + " knots along " + name_ + " for " + std::to_string(points_) +
             " control points: write as many more knots as the spline's order, which is 2 to " +
             std::to_string(std::min(kMostOrder, points_));
    }
    if (!rises()) return "has knots along " + name_ + " that do not rise, or too many equal ones: sort them";
    return {};
  }

 private:
  bool rises() const {
    std::int64_t equal = 1;
    for (std::int64_t i = 0; i < count_; ++i) {
      if (!std::isfinite(knot_[i]) || (i > 0 && knot_[i] < knot_[i - 1])) return false;
      equal = i > 0 && knot_[i] == knot_[i - 1] ? equal + 1 : 1;
      if (equal > order_) return false;
    }
    return knot_[order_ - 1] < knot_[points_];
  }

  std::string name_;
  std::int64_t points_;
  std::int64_t count_;
  const float* knot_;
  std::int64_t order_;
};

/// @param index  of the coordinates; null: they are taken in order
std::string reachFault(std::int64_t needed, std::int64_t available, const SoMFInt32* index) {
  if (index && index->getNum() < needed)
    return "has " + std::to_string(index->getNum()) + " indices for " + std::to_string(needed) + " control points";
  std::int64_t last = needed - 1;
  if (index) {
    const auto [least, most] = std::minmax_element(index->getValues(0), index->getValues(0) + needed);
    if (*least < 0) return "has an index below 0: write 0 or more";
    last = *most;
  }
  if (last < available) return {};
  return "reaches for coordinate " + std::to_string(last) + " (the first is 0), and there are " +
         std::to_string(available) + ": correct its counts, or add what is missing";
}

template <typename Surface>
std::string surfaceFault(const Surface& node, const AttributesInForce& state, const SoMFInt32* index,
                         const SoMFInt32* textureIndex) {
  const Spline u("u", node.numUControlPoints.getValue(), node.uKnotVector);
  const Spline v("v", node.numVControlPoints.getValue(), node.vKnotVector);
  const Spline s("s", node.numSControlPoints.getValue(), node.sKnotVector);
  const Spline t("t", node.numTControlPoints.getValue(), node.tKnotVector);
  if (!u.isUsed() && !v.isUsed()) return {};
  const bool hasTexture = s.isUsed() || t.isUsed();
  for (const Spline* spline : {&u, &v}) {
    if (std::string fault = spline->fault(); !fault.empty()) return fault;
  }
  for (const Spline* spline : {&s, &t}) {
    if (std::string fault = hasTexture ? spline->fault() : std::string(); !fault.empty()) return fault;
  }
  if (u.pieces() * v.pieces() > kMostPatches)
    return "has more than " + std::to_string(kMostPatches) + " patches: write triangles";
  std::string fault = reachFault(u.points() * v.points(), state.coordinates, index);
  if (fault.empty() && hasTexture)
    fault = reachFault(s.points() * t.points(), state.textureCoordinates.count, textureIndex);
  return fault;
}

template <typename Curve>
std::string curveFault(const Curve& node, const AttributesInForce& state, const SoMFInt32* index) {
  const Spline spline("it", node.numControlPoints.getValue(), node.knotVector);
  if (!spline.isUsed()) return {};
  std::string fault = spline.fault();
  if (fault.empty() && spline.pieces() > kMostPatches) fault = "has too many pieces: write lines";
  return fault.empty() ? reachFault(spline.points(), state.coordinates, index) : fault;
}

}  // namespace

bool isNurbs(const SoNode* node) {
  for (const SoType type : {SoNurbsSurface::getClassTypeId(), SoIndexedNurbsSurface::getClassTypeId(),
                            SoNurbsCurve::getClassTypeId(), SoIndexedNurbsCurve::getClassTypeId()}) {
    if (node && node->isOfType(type)) return true;
  }
  return false;
}

bool isEmptyNurbs(const SoNode* node) {
  static const SbName kCounts[] = {"numUControlPoints", "numVControlPoints", "numControlPoints"};
  return isNurbs(node) && std::ranges::all_of(kCounts, [node](const SbName& name) {
           const auto* count = dynamic_cast<const SoSFInt32*>(node->getField(name));
           return !count || count->getValue() == 0;
         });
}

std::string nurbsFault(const SoNode* node, const AttributesInForce& state) {
  if (const auto* surface = dynamic_cast<const SoNurbsSurface*>(node))
    return surfaceFault(*surface, state, nullptr, nullptr);
  if (const auto* surface = dynamic_cast<const SoIndexedNurbsSurface*>(node))
    return surfaceFault(*surface, state, &surface->coordIndex, &surface->textureCoordIndex);
  if (const auto* curve = dynamic_cast<const SoNurbsCurve*>(node)) return curveFault(*curve, state, nullptr);
  if (const auto* curve = dynamic_cast<const SoIndexedNurbsCurve*>(node))
    return curveFault(*curve, state, &curve->coordIndex);
  return {};
}

}  // namespace haptiv
