#include "scenegraph/judging/ContactDynamics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "haptics/control/Admittance.h"
#include "haptics/laws/IfThenRenderer.h"

namespace haptiv {
namespace {

TEST(ContactDynamics, FollowsThePaper) {
  const ContactDynamics wall{2, 2000, 20};
  EXPECT_NEAR(wall.naturalFrequency(), 31.6228, 1e-4);
  EXPECT_NEAR(wall.dampingRatio(), 0.158114, 1e-6);
  EXPECT_NEAR(wall.optimalStiffness(), 100, 1e-12);
}

TEST(ContactDynamics, IsDampedByHalfTheRootOfTwoAtTheOptimum) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0.1, 100);
  for (int i = 0; i < 100; ++i) {
    ContactDynamics contact{number(random), 0, number(random)};
    contact.stiffness = contact.optimalStiffness();
    EXPECT_NEAR(contact.dampingRatio(), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(contact.optimalDamping(), contact.damping, 1e-9 * contact.damping);
  }
}

/// A ball that a constant push holds against a wall, a little beside where it would rest: how far from there it is at
/// most in the last tenth of so many ticks, in parts of how far it was at first.
double growth(const ContactDynamics& contact, double period, int ticks) {
  constexpr double kPush = 100;  // [N]
  HapticScene scene;
  scene.tool = {contact.mass, 0, 0.01, Vector3::Zero()};
  const double atRest = kPush / contact.stiffness;
  Wall wall;
  wall.id = 1;
  wall.surface = {contact.stiffness, contact.damping, 0, 0, 0};
  const double half = 100 * atRest;  // no far side to think of
  wall.shape.centre = Vector3(scene.tool.radius + half, 0, 0);
  wall.shape.axes = Matrix3::Identity() * half;
  scene.walls.push_back(wall);
  computeBounds(scene);

  const double aside = 1e-3 * atRest;
  AdmittanceState ball{Vector3(atRest + aside, 0, 0), Vector3::Zero()};
  ContactSet contacts;
  double most = 0;
  for (int tick = 0; tick < ticks; ++tick) {
    const Vector3 wallForce = renderWalls(scene, {ball.position, ball.velocity, scene.tool.radius}, contacts);
    ball.velocity = nextVelocity(ball, Vector3(kPush, 0, 0) + wallForce, contact.mass, period);
    ball.position += period * ball.velocity;
    if (10 * tick > 9 * ticks) most = std::max(most, std::abs(ball.position.x() - atRest));
    if (most > 1e3 * aside) break;
  }
  return most / aside;
}

TEST(ContactDynamics, SettlesWithinTheSampledBoundAndShakesBeyondIt) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(0, 1);
  constexpr int kTicks = 3000;
  for (int i = 0; i < 60; ++i) {
    const double period = 1e-3 * (0.2 + part(random));
    const double mass = 0.2 + 5 * part(random);
    // Within: s + 2 r < 4, with some damping for it to settle by.
    const double r = 0.05 + 0.9 * part(random);
    ContactDynamics contact{mass, 0, r * mass / period};
    contact.stiffness = (0.05 + 0.9 * part(random)) * contact.largestSampledStiffness(period);
    ASSERT_LT(contact.usedOfSampledBound(period), 1);
    EXPECT_LT(growth(contact, period, kTicks), 1.01) << contact.stiffness * period * period / mass << " " << r;
    // Beyond s + r = 4 steps in and out together grow.
    contact.stiffness = (4.1 + part(random)) * mass / (period * period);
    ASSERT_GT(contact.usedOfSampledBound(period), 1);
    EXPECT_GT(growth(contact, period, kTicks), 100) << contact.stiffness * period * period / mass << " " << r;
  }
}

}  // namespace
}  // namespace haptiv
