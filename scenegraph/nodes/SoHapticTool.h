#pragma once

#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFVec3f.h>
#include <Inventor/nodes/SoSubNode.h>

namespace haptiv {

/// The ball that the hand moves; one per scene. Its fields are in the scene's coordinates: transforms before it do not
/// move it.
/// In files: HapticTool.
class SoHapticTool : public SoNode {
  typedef SoNode inherited;
  SO_NODE_HEADER(SoHapticTool);

 public:
  static void initClass();
  SoHapticTool();

  SoSFFloat mass;     ///< [kg], positive
  SoSFFloat damping;  ///< [N s/m] in free motion, not negative        [paper, eq. (28)]
  SoSFFloat radius;   ///< [m], positive
  SoSFVec3f home;     ///< [m], the middle of the ball where a session starts

 protected:
  ~SoHapticTool() override;
};

}  // namespace haptiv
