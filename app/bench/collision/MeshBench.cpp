#include "app/bench/collision/MeshBench.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/bench/scenes/MeshSphere.h"

namespace haptiv {
namespace {

constexpr std::uint32_t kTriangles = 1000000;
constexpr int kMeshPasses = 5;
constexpr int kMeshLegs = 20;
/// The triangles' middles lie this much below the sphere, at most [m]: half of it does not count as touching.
constexpr double kBelow = 1e-6;

/// What was felt, beside the time: against the exact sphere.
struct Felt {
  std::uint64_t missed = 0;
  double peak = 0, analyticPeak = 0;
};

void follow(const HapticScene& scene, const std::vector<ToolMotion>& path, double scale, CallTimes& contact,
            CallTimes& free, Felt& felt) {
  const SurfaceProperties& surface = scene.walls[0].surface;
  ContactSet contacts;
  for (const ToolMotion& tool : path) {
    const double depth = scale * kSphereRadius + tool.radius - tool.position.norm();
    CallTimes& times = depth > 0 ? contact : free;
    const Vector3 force = times.time([&] { return renderWalls(scene, tool, contacts); });
    const double inwards = std::max(0.0, -tool.velocity.dot(tool.position.normalized()));
    if (depth > kBelow * scale && contacts.count == 0) ++felt.missed;
    felt.peak = std::max(felt.peak, force.norm());
    if (depth > 0)
      felt.analyticPeak = std::max(felt.analyticPeak, surface.stiffness * depth + surface.damping * inwards);
  }
  contact.endPass();
  free.endPass();
}

void benchSphere(BenchRun& run, double scale, const std::string& suffix) {
  const HapticScene scene = meshSphere(kTriangles, scale);
  const std::vector<ToolMotion> path = pathOverSphere(kMeshLegs, scale);
  CallTimes contact(path.size()), free(path.size());
  Felt felt;
  for (int pass = 0; pass < kMeshPasses; ++pass) follow(scene, path, scale, contact, free, felt);
  const std::uint64_t triangles = scene.walls[0].shape.mesh->triangles.size();
  BenchResult result = resultOf("collision/mesh" + suffix, triangles, contact);
  result.notes = {{"missed_contacts", static_cast<double>(felt.missed)},
                  {"peak_force_over_sphere", felt.peak / felt.analyticPeak}};
  run.add(result);
  run.add(resultOf("collision/mesh/free" + suffix, triangles, free));
}

}  // namespace

void benchMesh(BenchRun& run) {
  const std::pair<double, const char*> scales[] = {{1, ""}, {0.1, "/x0.1"}, {10, "/x10"}};
  for (const auto& [scale, suffix] : scales) {
    run.tell(std::string("collision: a mesh of a million triangles, size x") + (scale == 1 ? "1" : suffix + 2));
    benchSphere(run, scale, suffix);
  }
}

}  // namespace haptiv
