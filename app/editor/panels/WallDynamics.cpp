#include "app/editor/panels/WallDynamics.h"

#include "scenegraph/judging/ContactDynamics.h"
#include "scenegraph/nodes/SoHapticSurface.h"

namespace haptiv {

QString wallDynamicsText(const SceneDocument& document, const SoNode* property) {
  const auto* surface = dynamic_cast<const SoHapticSurface*>(property);
  const auto& scene = document.compiled().scene;
  if (!surface || !scene) return {};
  const double stiffness = surface->stiffness.getValue(), damping = surface->damping.getValue();
  if (!(stiffness > 0) || !(damping >= 0)) return {};
  const ContactDynamics contact{scene->tool.mass, stiffness, damping};
  const double peak = document.device().hand.peakForce;
  return QString(
             "Damping ratio %1; 0.71 settles quickest, with a damping of %2 N s/m. "
             "The peak force of %3 N presses the ball %4 cm deep.")
      .arg(contact.dampingRatio(), 0, 'g', 2)
      .arg(contact.optimalDamping(), 0, 'g', 3)
      .arg(peak, 0, 'g', 3)
      .arg(100 * peak / stiffness, 0, 'g', 2);
}

}  // namespace haptiv
