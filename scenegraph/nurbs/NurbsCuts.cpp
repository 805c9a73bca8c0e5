#include "scenegraph/nurbs/NurbsCuts.h"

#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "scenegraph/Keyword.h"
#include "scenegraph/isolation/Isolated.h"

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;
using Places = std::span<const TrimmedPlace>;
using std::chrono::milliseconds;

// Of SoComplexity.
constexpr float kFinest = 1;
constexpr float kUsual = 0.5F;

constexpr std::size_t kMostCorners = 6'000'000;  // of all that are cut at once; some 200 MB
constexpr std::size_t kMany = 500;               // at Coin's usual fineness some 50 triangles each, at its finest 2000
constexpr std::chrono::seconds kTimeForOne{1};   // a million triangles

void takeCorner(CutSurface& surface, const SoPrimitiveVertex& corner) {
  const SbVec4f& texture = corner.getTextureCoords();
  surface.push_back({corner.getPoint(), corner.getNormal(), {texture[0], texture[1]}});
}

void takeTriangle(void* surface, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
                  const SoPrimitiveVertex* c) {
  auto& corners = *static_cast<CutSurface*>(surface);
  if (corners.size() > kMostCorners) return;
  for (const SoPrimitiveVertex* corner : {a, b, c}) takeCorner(corners, *corner);
}

/// By GLU, in this process.
CutSurface cutByGlu(const TrimmedPlace& place, float fineness) {
  CutSurface corners;
  SoCallbackAction action;
  action.addTriangleCallback(SoShape::getClassTypeId(), &takeTriangle, &corners);
  action.apply(place.graph(fineness).get());
  return corners;
}

/// The work of the process: of each how many bytes its corners have, and these. Too many are none.
std::string cutAll(Places places, float fineness, milliseconds longest) {
  std::string cut;
  const auto end = Clock::now() + longest;
  for (std::size_t i = 0; i < places.size() && Clock::now() < end; ++i) {
    tellProgress("cuts " + describe(places[i].surface()), static_cast<int>(i + 1));
    allowTime(kTimeForOne);
    const CutSurface corners = cutByGlu(places[i], fineness);
    std::uint64_t bytes = corners.size() * sizeof(CutCorner);
    if (cut.size() + bytes > kMostCorners * sizeof(CutCorner)) bytes = 0;
    cut.append(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
    cut.append(reinterpret_cast<const char*>(corners.data()), bytes);
  }
  return cut;
}

/// Of the next one; GLU may have damaged the process that wrote it.
CutSurface readCut(std::string_view& cut) {
  std::uint64_t bytes = 0;
  if (cut.size() < sizeof(bytes)) return {};
  std::memcpy(&bytes, cut.data(), sizeof(bytes));
  cut.remove_prefix(sizeof(bytes));
  bytes = std::min<std::uint64_t>(bytes, cut.size());
  CutSurface corners(bytes / (3 * sizeof(CutCorner)) * 3);
  if (!corners.empty()) std::memcpy(static_cast<void*>(corners.data()), cut.data(), corners.size() * sizeof(CutCorner));
  cut.remove_prefix(bytes);
  return corners;
}

}  // namespace

void NurbsCuts::cut(Places places, milliseconds longest) {
  std::vector<TrimmedPlace> unknown;
  for (const TrimmedPlace& place : places) {
    if (known_.size() >= kMostSurfaces) break;
    if (known_.try_emplace(place.key()).second && !place.key().empty()) unknown.push_back(place);
  }
  const float fineness = unknown.size() > kMany ? kUsual : kFinest;
  const auto begin = Clock::now();
  const auto end = begin + std::min(longest, left_);
  for (Places rest = unknown; !rest.empty() && Clock::now() < end;) {
    const auto left = std::chrono::ceil<milliseconds>(end - Clock::now());
    const std::size_t good = cutInOneGo(rest, fineness, left);
    if (good < rest.size()) cutInOneGo(rest.first(good), fineness, left);
    rest = rest.subspan(std::min(good + 1, rest.size()));
  }
  left_ -= std::chrono::duration_cast<milliseconds>(Clock::now() - begin);
}

std::size_t NurbsCuts::cutInOneGo(Places places, float fineness, milliseconds longest) {
  if (places.empty()) return 0;
  const auto time = std::chrono::ceil<std::chrono::seconds>(longest) + 2 * kTimeForOne;
  const Isolated made = runIsolated([&] { return cutAll(places, fineness, longest); }, time);
  if (!made.fault.empty()) return static_cast<std::size_t>(std::max(made.line - 1, 0));
  std::string_view rest = made.result;
  for (const TrimmedPlace& place : places) known_[place.key()] = readCut(rest);
  return places.size();
}

const CutSurface& NurbsCuts::at(const TrimmedPlace& place) {
  static const CutSurface kNothing;
  if (!known_.contains(place.key())) cut({&place, 1}, left_);
  const auto known = known_.find(place.key());
  return known == known_.end() ? kNothing : known->second;
}

}  // namespace haptiv
