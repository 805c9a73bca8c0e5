#pragma once

#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFRotation.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/fields/SoSFVec3f.h>
#include <Inventor/nodes/SoSubNode.h>

namespace haptiv {

/// Where frame B of the device stands in the scene, and how its motion scales: p_WT = position + scale * R * p_BT, with
/// R from `orientation`. Its fields are in the scene's coordinates: transforms before it do not move it. At most one
/// per scene; without one the defaults hold.
/// In files: HapticDevice.
class SoHapticDevice : public SoNode {
  typedef SoNode inherited;
  SO_NODE_HEADER(SoHapticDevice);

 public:
  static void initClass();
  SoHapticDevice();

  SoSFString description;    ///< name of the device description
  SoSFVec3f position;        ///< [m]
  SoSFRotation orientation;  ///< turns axes of B into the scene's
  SoSFFloat scale;           ///< scene metres per device metre, positive

 protected:
  ~SoHapticDevice() override;
};

}  // namespace haptiv
