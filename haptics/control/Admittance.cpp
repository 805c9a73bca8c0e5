#include "haptics/control/Admittance.h"

namespace haptiv {

Vector3 nextVelocity(const AdmittanceState& state, const Vector3& force, double mass, double dt) noexcept {
  return state.velocity + force * (dt / mass);
}

}  // namespace haptiv
