#include <gtest/gtest.h>

#include <cmath>

#include "haptics/control/Admittance.h"
#include "haptics/laws/IfThenRenderer.h"
#include "haptics/shapes/ShapeDistance.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::RandomShapes;

constexpr double kPeriod = 1e-3;

/// Energy that a ball of 2 kg has after one bounce, as a part of what it came with; none where it missed the wall.
double energyAfterABounce(const HapticScene& scene, AdmittanceState ball) {
  const double before = ball.velocity.squaredNorm();
  ContactSet contacts;
  bool touched = false;
  for (int tick = 0; tick < 5000; ++tick) {
    const Vector3 force = renderWalls(scene, {ball.position, ball.velocity, 0.01}, contacts);
    if (touched && contacts.count == 0) break;
    touched = touched || contacts.count > 0;
    ball.velocity = nextVelocity(ball, force, 2, kPeriod);
    ball.position += kPeriod * ball.velocity;
  }
  return touched ? ball.velocity.squaredNorm() / before : 0;
}

HapticScene oneWall(const Shape& shape, double damping) {
  HapticScene scene;
  Wall wall;
  wall.id = 1;
  wall.shape = shape;
  wall.surface.damping = damping;
  scene.walls = {wall};
  computeBounds(scene);
  return scene;
}

/// The semi-implicit step conserves a shadow energy that differs from the true one by w dt / 2 at most; the ends of the
/// contact fall between two ticks, which does as much again. w = sqrt(k/m) = 32 rad/s: 0.032 in all.
constexpr double kBound = 0.035;

TEST(AWall, ReturnsNoMoreEnergyThanWasPutInButForTheStepsError) {
  RandomShapes random(1);
  double most = 0;
  for (int run = 0; run < 300; ++run) {
    const Shape shape = run % 5 == 4 ? random.skewedBox() : random.shape(static_cast<Shape::Kind>(run % 5));
    const Vector3 target = random.onSurface(shape);
    const Vector3 out = nearestSurface(shape, target + 1e-6 * (target - shape.centre)).normal;
    AdmittanceState ball;
    ball.velocity = random.between(0.1, 1) * (random.direction() - 1.2 * out).normalized();
    ball.position = target + 0.011 * out;
    if (nearestSurface(shape, ball.position).distance < 0.01) continue;
    ball.position += random.between(0, kPeriod) * ball.velocity;
    most = std::max(most, energyAfterABounce(oneWall(shape, 0), ball));
  }
  EXPECT_LT(most, 1 + kBound);
  EXPECT_GT(most, 1 - kBound);  // and no less either: the wall is a spring, not a brake
}

TEST(AWall, TakesEnergyAwayWhereItIsDamped) {
  Shape shape;
  AdmittanceState ball;
  ball.position = {0, 0, 1.1};
  ball.velocity = {0, 0, -0.5};
  // zeta = b / (2 sqrt(k m)) = 0.158 on the way in only: exp(-pi zeta) of the speed is left at most half of it undone.
  EXPECT_LT(energyAfterABounce(oneWall(shape, 20), ball), 0.8);
}

}  // namespace
}  // namespace haptiv
