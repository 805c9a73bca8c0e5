#pragma once

#include <Inventor/SbColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include "device/types.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// A translucent ellipsoid with its three principal axes as lines. Also flat, where the arm is singular. Thread: GUI.
class ManipulabilityEllipsoid {
 public:
  explicit ManipulabilityEllipsoid(const SbColor& color);

  SoSeparator* root() const { return root_.get(); }
  void setVisible(bool visible);
  bool isVisible() const;
  /// @param centre    in W [m]
  /// @param axes      orthonormal columns, in W
  /// @param halfAxes  falling; as they are to be drawn [m]
  void show(const Vector3& centre, const Matrix3& axes, const Vector3& halfAxes);

 private:
  NodeRef<SoSeparator> root_;
  SoSwitch* shown_;
  SoTransform* place_;
};

}  // namespace haptiv
