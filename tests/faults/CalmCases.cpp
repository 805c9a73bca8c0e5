#include <algorithm>
#include <cmath>

#include "tests/faults/FaultCases.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv::faults {
namespace {

using Chain = FaultChain;

/// A mesh across x, 50 mm before the ball, with waves along y: so high from the mean, so long [m].
Wall rough(const Vector3& home, double height, double length) {
  constexpr double kHalf = 0.35;
  const int strips = static_cast<int>(2 * kHalf / length * 12);
  testing::Soup soup;
  const auto at = [&](int i, double z) {
    const double y = -kHalf + 2 * kHalf * i / strips;
    return Vector3(home + Vector3(0.06 + height * std::cos(2 * M_PI * y / length), y, z));
  };
  for (int i = 0; i < strips; ++i) soup.addQuad(at(i, -0.2), at(i, 0.2), at(i + 1, 0.2), at(i + 1, -0.2));
  return testing::meshWall(soup);
}

/// The hand presses 20 N and more, and strokes along y at this speed [m/s], to and fro.
Chain::Script stroking(double speed) {
  return [speed](Chain& chain, int) {
    constexpr double kWay = 0.25;  // [m]
    const double on = std::max(0.0, chain.time() - 0.8) * speed;
    const double y = std::abs(std::fmod(on + kWay, 2 * kWay) - kWay);
    chain.hand.target.holding = true;
    chain.hand.target.position = chain.home() + std::min(1.0, chain.time() / 0.5) * Vector3(0.11, y - kWay / 2, 0);
  };
}
/// The hand throws the ball at the wall.
void throwAtWall(Chain& chain, int since) {
  chain.hand.target.holding = true;
  chain.hand.target.position = chain.home() + Vector3(since < 0 ? -0.2 : 0.15, 0, 0);
}
void lean(Chain& chain, int) {
  pressOnWall(chain);
}

template <double kStiffness, double kDamping>
void stiff(Chain& chain) {
  chain.scene.walls[0].surface.stiffness = kStiffness;
  chain.scene.walls[0].surface.damping = kDamping;
}
template <double kHeight, double kLength>
void waves(Chain& chain) {
  chain.scene.walls = {rough(chain.home(), kHeight, kLength)};
  computeBounds(chain.scene);
}
template <double kHeight, double kLength>
void wavesOfALightBall(Chain& chain) {
  waves<kHeight, kLength>(chain);
  chain.scene.tool.mass = 0.5;
}
void rubber(Chain& chain) {
  chain.scene.walls[0].surface.staticFriction = 0.9;
  chain.scene.walls[0].surface.dynamicFriction = 0.5;
}

}  // namespace

FaultGroup calmCases() {
  const auto running = SessionState::running;
  const auto calm = [&](const char* what, const Chain::Script& script, void (*arrange)(Chain&)) {
    return FaultCase{what, kNoFault, kNoClamp, running, 0, script, 1, 3, arrange};
  };
  return {"Felt, and no fault",
          {calm("a wall of 1,000,000 N/m is pressed", lean, stiff<1e6, 20.0>),
           calm("the ball is thrown into a wall of 20,000 N/m without damping", throwAtWall, stiff<2e4, 0.0>),
           calm("the ball is thrown into a wall of 300,000 N/m", throwAtWall, stiff<3e5, 20.0>),
           calm("a mesh of waves, 1 mm high, 8 mm long, at 0.3 m/s", stroking(0.3), waves<5e-4, 0.008>),
           calm("the same, 2 mm high, 20 mm long, at 0.6 m/s", stroking(0.6), waves<1e-3, 0.02>),
           calm("the same with a ball of 0.5 kg", stroking(0.6), wavesOfALightBall<1e-3, 0.02>),
           calm("a wall of rubber, at 0.02 m/s", stroking(0.02), rubber),
           calm("a wall of rubber, at 0.3 m/s", stroking(0.3), rubber)}};
}

}  // namespace haptiv::faults
