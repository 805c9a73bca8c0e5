#include "app/bench/collision/MeshBench.h"

#include <algorithm>

#include "app/bench/collision/MeshSphere.h"

namespace haptiv {
namespace {

constexpr std::uint32_t kTriangles = 1000000;
constexpr int kPasses = 5;
constexpr int kLegs = 20;
/// The triangles' middles lie this much below the sphere, at most [m]: half of it does not count as touching.
constexpr double kBelow = 1e-6;

}  // namespace

void benchMesh(BenchRun& run) {
  run.tell("collision: a mesh of a million triangles");
  const HapticScene scene = meshSphere(kTriangles);
  const SurfaceProperties& surface = scene.walls[0].surface;
  const std::vector<ToolMotion> path = pathOverSphere(kLegs);
  CallTimes contact(path.size()), free(path.size());
  std::uint64_t missed = 0;
  double peak = 0, analyticPeak = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    ContactSet contacts;
    for (const ToolMotion& tool : path) {
      const double depth = kSphereRadius + tool.radius - tool.position.norm();
      CallTimes& times = depth > 0 ? contact : free;
      const Vector3 force = times.time([&] { return renderWalls(scene, tool, contacts); });
      const double inwards = std::max(0.0, -tool.velocity.dot(tool.position.normalized()));
      if (depth > kBelow && contacts.count == 0) ++missed;
      peak = std::max(peak, force.norm());
      if (depth > 0) analyticPeak = std::max(analyticPeak, surface.stiffness * depth + surface.damping * inwards);
    }
    contact.endPass();
    free.endPass();
  }
  const std::uint64_t triangles = scene.walls[0].shape.mesh->triangles.size();
  BenchResult result = resultOf("collision/mesh", triangles, contact);
  result.notes = {{"missed_contacts", static_cast<double>(missed)}, {"peak_force_over_sphere", peak / analyticPeak}};
  run.add(result);
  run.add(resultOf("collision/mesh/free", triangles, free));
}

}  // namespace haptiv
