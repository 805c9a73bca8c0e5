#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "haptics/laws/IfThenRenderer.h"
#include "haptics/shapes/ShapeDistance.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::boxSoup;
using testing::kRest;
using testing::meshWall;
using testing::moved;
using testing::plateSoup;
using testing::RandomShapes;
using testing::sceneOf;
using testing::Soup;
using testing::sphereSoup;
using testing::wallBelow;

TEST(MeshContact, FollowsTheBallInTheFreeWithoutLag) {
  RandomShapes random(1);
  const HapticScene scene = sceneOf({meshWall(sphereSoup(0.1, 20))});
  ContactSet contacts;
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = random.between(0.1102, 0.3) * random.direction();
    if (contacts.started && (p - contacts.surfacePosition).norm() > 0.02) contacts = {};  // do not pass the sphere
    EXPECT_EQ(renderWalls(scene, {p, kRest, 0.01}, contacts), Vector3::Zero());
    EXPECT_EQ(contacts.surfacePosition, p);
  }
}

/// 170 N against 2000 N/m is 85 mm. The walls: a plate of two triangles, and a box of 5 mm.
TEST(MeshContact, DoesNotLetTheHardestHandThroughAThinMeshFromAnyDirection) {
  RandomShapes random(2);
  for (int run = 0; run < 200; ++run) {
    const Matrix3 R = random.rotation();
    const Vector3 t = random.vector(1);
    const Soup soup =
        run % 2 == 0 ? plateSoup(2) : boxSoup({0, 0, -0.0025}, Vector3(2, 2, 0.0025).asDiagonal(), 1 + run % 7);
    const HapticScene scene = sceneOf({meshWall(moved(soup, R, t))});
    const Vector3 towards = random.direction();
    const Vector3 hand = 170 * (R * Vector3(towards.x(), towards.y(), -std::abs(towards.z())));
    const Vector3 out = R.col(2);
    Vector3 p = 0.012 * out + t;
    ContactSet contacts;
    Vector3 force = kRest;
    for (int tick = 0; tick < 2000; ++tick) {
      force = renderWalls(scene, {p, kRest, 0.01}, contacts);
      p += 1e-4 * out * (std::min(1.0, tick / 1000.0) * hand + force).dot(out);  // without inertia: it settles
      p += 2e-4 * (hand - hand.dot(out) * out) / 170;  // and slides aside under the rest of the force
    }
    ASSERT_EQ(contacts.count, 1);
    EXPECT_NEAR(force.dot(out), -hand.dot(out), 0.1);
    EXPECT_NEAR(contacts.contact[0].depth, -hand.dot(out) / 2000, 1e-4);
  }
}

TEST(MeshContact, StopsTheFastestBallOnTheSideFromWhichItCame) {
  RandomShapes random(3);
  const HapticScene scene = sceneOf({meshWall(plateSoup(1, 5))});
  for (int run = 0; run < 500; ++run) {
    const double side = run % 2 == 0 ? 1 : -1;
    const Vector3 from(random.between(-0.3, 0.3), random.between(-0.3, 0.3), side * random.between(0.02, 0.5));
    const Vector3 to(random.between(-0.5, 0.5), random.between(-0.5, 0.5), -side * random.between(0.02, 0.5));
    ContactSet contacts;
    renderWalls(scene, {from, kRest, 0.01}, contacts);
    for (int tick = 0; tick < 3; ++tick) {
      const Vector3 force = renderWalls(scene, {to, kRest, 0.01}, contacts);
      EXPECT_NEAR(force.z(), 2000 * (0.01 * side - to.z()), 1e-3);
    }
  }
}

/// A sphere of 80,000 triangles is within 8e-4 of its radius of the true one; forces are compared by that and the tilt.
TEST(MeshContact, FeelsASphereOfTrianglesLikeTheSphere) {
  RandomShapes random(4);
  for (const double scale : {0.1, 1.0, 10.0}) {
    const double radius = 0.001 * scale;
    const HapticScene scene = sceneOf({meshWall(sphereSoup(0.1 * scale, 142))});
    ContactSet contacts;
    const Vector3 u = random.direction(), v = u.unitOrthogonal();
    double strongest = 0;
    for (int tick = 0; tick < 20000; ++tick) {
      const double depth = 0.0015 * scale * std::sin(tick * 1e-3);  // deeper than the ball is large
      const double angle = tick * 2e-4;
      const Vector3 out = std::cos(angle) * u + std::sin(angle) * v;
      const Vector3 force = renderWalls(scene, {(0.1 * scale + radius - depth) * out, kRest, radius}, contacts);
      const double expected = 2000 * std::max(0.0, depth);
      EXPECT_LT((force - expected * out).norm(), 0.03 * expected + 2000 * 5e-5 * scale) << tick;
      ASSERT_TRUE(contacts.count > 0 || depth < 1e-4 * scale) << tick;
      strongest = std::max(strongest, force.norm());
    }
    EXPECT_NEAR(strongest, 3 * scale, 0.05 * 3 * scale);
  }
}

/// However finely the faces are cut, inner edges are not felt. Along edges and corners, too, the mesh is the box.
TEST(MeshContact, FeelsABoxOfTrianglesLikeTheBox) {
  RandomShapes random(5);
  for (int run = 0; run < 60; ++run) {
    Wall box;
    box.shape = run % 2 == 0 ? random.shape(Shape::Kind::box, 0.1) : random.skewedBox();
    const HapticScene exact = sceneOf({box});
    const HapticScene mesh = sceneOf({meshWall(boxSoup(box.shape.centre, box.shape.axes, 1 + run % 9))});
    ContactSet exactContacts, meshContacts;
    const Vector3 start = random.onSurface(box.shape), end = random.onSurface(box.shape);
    Vector3 p = start + 0.02 * nearestSurface(box.shape, start + 1e-3 * (start - box.shape.centre)).normal;
    for (int tick = 0; tick < 3000; ++tick) {
      // Towards a place on the surface, kept within the depth at which a path has one nearest place of the surface.
      const Vector3 next = p + 1e-4 * (end - p).normalized();
      const SurfacePoint surface = nearestSurface(box.shape, next);
      p = next + std::max(0.0, 0.006 - surface.distance) * surface.normal;
      const Vector3 a = renderWalls(exact, {p, kRest, 0.01}, exactContacts);
      const Vector3 b = renderWalls(mesh, {p, kRest, 0.01}, meshContacts);
      // The exact wall is linear around the place of the tick before: at an edge it lags by a tick's turn.
      EXPECT_LT((a - b).norm(), 0.02 * a.norm() + 1e-3) << run << " " << tick;
    }
  }
}

TEST(MeshContact, ChangesItsForceContinuouslyOverFacesEdgesAndCorners) {
  RandomShapes random(6);
  for (int run = 0; run < 30; ++run) {
    Soup soup = run % 3 == 0 ? sphereSoup(0.05, 5) : boxSoup(kRest, 0.05 * Matrix3::Identity(), 1 + run % 5);
    if (run % 3 == 2) soup = plateSoup(0.05, 4);
    const HapticScene scene = sceneOf({meshWall(moved(soup, random.rotation(), kRest))});
    ContactSet contacts;
    const double step = 2e-5;
    Vector3 p = 0.12 * random.direction(), way = -p.normalized();
    Vector3 last = renderWalls(scene, {p, kRest, 0.01}, contacts);
    for (int tick = 0; tick < 20000; ++tick) {
      // A random walk that presses on, but no deeper than the ball is large: beyond that an edge lets go of it.
      way = (way + 0.02 * random.vector(1) - 0.002 * p.normalized()).normalized();
      if ((p - contacts.surfacePosition).norm() > 0.007) way = (contacts.surfacePosition - p).normalized();
      p += step * way;
      const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
      // Over an edge the way of the proxy is r / (r - d) times as long as the ball's: 3.3 here.
      EXPECT_LT((force - last).norm(), 2000 * step * 4.5 + 0.02) << run << " " << tick;
      last = force;
    }
  }
}

TEST(MeshContact, LetsGoOverAnEdgeByTurningTheForce) {
  // Pressed 60 mm deep, the ball is dragged over the edge of a plate.
  const HapticScene scene = sceneOf({meshWall(plateSoup(0.1, 3))});
  ContactSet contacts;
  Vector3 p(0, 0, 0.011);
  Vector3 last = kRest;
  for (int tick = 0; tick < 4000; ++tick) {
    p += tick < 800 ? Vector3(0, 0, -1e-4 * 0.76125) : Vector3(5e-5, 0, 0);
    const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
    EXPECT_LT((force - last).norm(), 120 * 0.12) << tick;  // a sixteenth of a radian a tick, and something
    last = force;
  }
  EXPECT_EQ(last, Vector3::Zero());
  EXPECT_EQ(contacts.surfacePosition, p);
}

TEST(MeshContact, HoldsTheBallInACornerOfAMeshAndAnExactWall) {
  Wall across = wallBelow(0.1);
  across.shape.centre = {0.5, 0, 0.05};
  across.shape.axes = Vector3(0.0025, 2, 0.05).asDiagonal();
  const HapticScene scene = sceneOf({meshWall(plateSoup(1, 10)), across});
  ContactSet contacts;
  Vector3 force = kRest;
  for (double s = 0; s < 1; s += 0.001) {
    const Vector3 p(0.44 + 0.1 * s, 0, 0.011 - 0.1 * std::min(1.0, 2 * s));
    force = renderWalls(scene, {p, kRest, 0.01}, contacts);
  }
  EXPECT_EQ(contacts.count, 2);
  EXPECT_NEAR(force.z(), 2000 * (0.01 + 0.089), 1);
  EXPECT_NEAR(force.x(), -2000 * (0.54 - 0.4875 - 0.0001), 1);
}

TEST(MeshContact, DoesNotHangInAGroove) {
  for (const double slope : {0.15, 0.5, 1.0, 1.35}) {
    const double c = std::cos(slope), s = std::sin(slope);
    Soup soup;
    for (int i = -10; i < 10; ++i) {
      const Vector3 a(0, 0.05 * i, 0), b(0, 0.05 * (i + 1), 0), out(c, 0, s), mirrored(-c, 0, s);
      soup.addQuad(a, a + out, b + out, b);
      soup.addQuad(a, b, b + mirrored, a + mirrored);
    }
    const HapticScene scene = sceneOf({meshWall(soup)});
    ContactSet contacts;
    for (int tick = 0; tick < 2000; ++tick) {
      const Vector3 p(0.002, 1e-4 * std::max(0, tick - 500) - 0.1, 0.05 - 0.0002 * std::min(tick, 400));
      const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
      // An inner edge ahead may still turn a normal by a little more than what counts as none.
      EXPECT_NEAR(force.y(), 0, 2e-3 * force.norm()) << tick;
      EXPECT_NEAR(contacts.surfacePosition.y(), p.y(), 2e-3 * 0.01) << tick << " slope " << slope;
    }
    EXPECT_EQ(contacts.count, 2);
  }
}

TEST(MeshContact, IsTheSameAtAnyScale) {
  RandomShapes random(7);
  const Soup soup = boxSoup(kRest, 0.05 * Matrix3::Identity(), 3);
  ContactSet contacts[3];
  HapticScene scenes[3];
  const double scales[3] = {0.1, 1, 10};
  for (int i = 0; i < 3; ++i) scenes[i] = sceneOf({meshWall(moved(soup, scales[i] * Matrix3::Identity(), kRest))});
  Vector3 p(0, 0, 0.07);
  for (int tick = 0; tick < 5000; ++tick) {
    p += 1e-4 * (random.vector(1) - 5 * p);
    Vector3 force[3];
    for (int i = 0; i < 3; ++i)
      force[i] = renderWalls(scenes[i], {scales[i] * p, kRest, scales[i] * 0.01}, contacts[i]);
    EXPECT_LT((force[0] / 0.1 - force[1]).norm(), 1e-4 * force[1].norm() + 1e-9) << tick;
    EXPECT_LT((force[2] / 10 - force[1]).norm(), 1e-4 * force[1].norm() + 1e-9) << tick;
  }
}

TEST(MeshContact, PushesOutOfAClosedMeshThatAppearsAroundTheBall) {
  const HapticScene scene = sceneOf({meshWall(boxSoup({0, 0, -0.05}, Vector3(2, 2, 0.05).asDiagonal(), 3))});
  ContactSet contacts;
  const Vector3 force = renderWalls(scene, {{0, 0, -0.02}, kRest, 0.01}, contacts);
  EXPECT_NEAR(force.z(), 2000 * 0.03, 1e-6);
}

TEST(MeshContact, GoesAlongWithAMeshThatIsMovedAndLetsGoOfOneThatIsGone) {
  const auto at = [](double z) {
    HapticScene scene = sceneOf({meshWall(moved(plateSoup(1), Matrix3::Identity(), {0, 0, z}))});
    scene.version = static_cast<std::uint32_t>(100 + 1e4 * z);
    return scene;
  };
  ContactSet contacts;
  const HapticScene first = at(0);
  for (double z = 0.012; z > -0.03; z -= 0.001) renderWalls(first, {{0, 0, z}, kRest, 0.01}, contacts);
  // Dragged up through the ball's centre and down again, by less than the ball's size at a time.
  for (const double height : {0.004, 0.016, 0.031, 0.015, -0.003}) {
    const Vector3 force = renderWalls(at(height), {{0, 0, -0.03}, kRest, 0.01}, contacts);
    EXPECT_NEAR(force.z(), 2000 * (0.04 + height), 1e-3);
  }
  HapticScene gone = sceneOf({});
  gone.version = 99;
  EXPECT_EQ(renderWalls(gone, {{0, 0, -0.03}, kRest, 0.01}, contacts), Vector3::Zero());
}

TEST(MeshContact, SurvivesTrianglesThatAreNone) {
  RandomShapes random(8);
  TriangleMesh wild;
  for (int i = 0; i < 60; ++i) wild.vertices.push_back(i % 3 == 0 ? Vector3(0.01, 0, 0) : random.vector(0.02));
  for (std::uint32_t i = 0; i < 60; ++i) wild.triangles.push_back({i, i * 7 % 60, i % 2 == 0 ? i : i * 11 % 60});
  Wall wall;
  wall.shape.kind = Shape::Kind::mesh;
  wall.shape.mesh = restoreTriangleMesh(wild.vertices, wild.triangles);
  const HapticScene scene = sceneOf({wall});
  ContactSet contacts;
  Vector3 p(0.05, 0, 0);
  for (int tick = 0; tick < 5000; ++tick) {
    p += 1e-3 * (random.vector(1) - 10 * p);
    EXPECT_TRUE(renderWalls(scene, {p, random.vector(1), 0.01}, contacts).allFinite());
    EXPECT_TRUE(contacts.surfacePosition.allFinite());
  }
}

}  // namespace
}  // namespace haptiv
