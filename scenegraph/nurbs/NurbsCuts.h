#pragma once

#include <Inventor/SbVec2f.h>
#include <Inventor/SbVec3f.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "scenegraph/nurbs/TrimmedPlace.h"

namespace haptiv {

/// A corner of a triangle that GLU has cut, in the surface's coordinates.
struct CutCorner {
  SbVec3f point;
  SbVec3f normal;
  SbVec2f texture;
};

/// The triangles of a surface, three corners each.
using CutSurface = std::vector<CutCorner>;

/// Triangles of the trimmed NURBS surfaces of a scene. On some trimming loops GLU does not end, or crashes: it cuts in
/// processes of their own, each surface once, which has a second of a processor, or two. All that is cut of a scene has
/// half a minute, whatever is changed in it, and kMostSurfaces are kept. Thread: GUI.
class NurbsCuts {
 public:
  static constexpr std::size_t kMostSurfaces = 10'000;

  /// Cuts what is not known yet, at Coin's finest, or at its usual fineness where it is much, in as few processes as
  /// GLU's crashes allow. What there is no time for is left out. Where GLU fails late, what went before is cut again:
  /// twice the time.
  void cut(std::span<const TrimmedPlace> places, std::chrono::milliseconds longest);

  /// Cut now where it is not known. Empty where GLU has made nothing of it, or no time is left.
  const CutSurface& at(const TrimmedPlace& place);

 private:
  /// @return  how many have been gone through: not all where the next one ended it, and then none is known
  std::size_t cutInOneGo(std::span<const TrimmedPlace> places, float fineness, std::chrono::milliseconds longest);

  std::map<TrimmedPlace::Key, CutSurface> known_;
  std::chrono::milliseconds left_{30'000};
};

}  // namespace haptiv
