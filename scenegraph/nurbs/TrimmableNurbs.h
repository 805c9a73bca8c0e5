#pragma once

#include <memory>

#include "scenegraph/nurbs/NurbsCuts.h"

namespace haptiv {

/// What every NURBS surface of a scene is besides: where profiles trim it, it is what stands in these cuts; nothing
/// without them. It is written as any other.
class TrimmableNurbs {
 public:
  std::shared_ptr<NurbsCuts> cuts;  ///< of the scene; copies have the same

 protected:
  TrimmableNurbs() = default;
  ~TrimmableNurbs() = default;
};

/// From now on, Coin makes NURBS surfaces that never have GLU trim them in this process. Once, after SoDB::init.
void makeNurbsTrimmable();

}  // namespace haptiv
