#include <algorithm>
#include <string>

#include "app/bench/Benches.h"
#include "app/bench/collision/FlatScan.h"
#include "app/bench/collision/MeshBench.h"
#include "app/bench/scenes/WallFloor.h"

namespace haptiv {
namespace {

constexpr int kWallPasses = 7;
constexpr int kWallLegs = 50;            // of the path: 45,000 ticks
constexpr std::size_t kPeerCalls = 500;  // a pass: it is slow

struct Times {
  explicit Times(std::size_t most) : contact(most), free(most) {}
  void endPass() {
    contact.endPass();
    free.endPass();
  }
  CallTimes contact, free;
};

/// Follows the path; returns in how many ticks the ball touched a wall and the renderer felt none.
std::uint64_t follow(const WallFloor& floor, const std::vector<ToolMotion>& path, const std::vector<char>& touching,
                     Times& times) {
  std::uint64_t missed = 0;
  ContactSet contacts;
  for (std::size_t i = 0; i < path.size(); ++i) {
    CallTimes& kind = touching[i] ? times.contact : times.free;
    kind.time([&] { return renderWalls(floor.scene(), path[i], contacts); });
    if (touching[i] && contacts.count == 0) ++missed;
  }
  times.endPass();
  return missed;
}

void scan(const FlatScan& peer, const std::vector<ToolMotion>& path, const std::vector<char>& touching, Times& times) {
  const std::size_t step = std::max<std::size_t>(1, path.size() / kPeerCalls);
  for (std::size_t i = 0; i < path.size(); i += step) {
    CallTimes& kind = touching[i] ? times.contact : times.free;
    kind.time([&] { return peer.force(path[i]); });
  }
  times.endPass();
}

void benchFloor(BenchRun& run, std::uint32_t walls, double scale, const std::string& suffix) {
  const WallFloor floor(walls, scale);
  const std::vector<ToolMotion> path = pathOver(floor, kWallLegs);
  std::vector<char> touching(path.size());
  std::ranges::transform(path, touching.begin(),
                         [&](const ToolMotion& tool) { return floor.isTouching(tool.position); });
  const FlatScan peer(floor.scene());
  Times own(path.size()), others(path.size());
  std::uint64_t missed = 0;
  for (int pass = 0; pass < kWallPasses; ++pass) {  // both in turn, under the same load of the machine
    missed += follow(floor, path, touching, own);
    scan(peer, path, touching, others);
  }
  for (const bool contact : {true, false}) {
    BenchResult result =
        resultOf((contact ? "collision/contact" : "collision/free") + suffix, walls, contact ? own.contact : own.free);
    result.peer = "flat scan";
    result.peerMedianNs = (contact ? others.contact : others.free).median();
    if (contact) result.notes = {{"missed_contacts", static_cast<double>(missed)}};
    run.add(result);
  }
}

}  // namespace

void benchCollision(BenchRun& run) {
  const std::pair<double, const char*> scales[] = {{1, ""}, {0.1, "/x0.1"}, {10, "/x10"}};
  for (const auto& [scale, suffix] : scales) {
    for (const std::uint32_t walls : {100U, 10000U, 100000U}) {
      run.tell("collision: " + std::to_string(walls) + " walls, size x" + (scale == 1 ? "1" : suffix + 2));
      benchFloor(run, walls, scale, suffix);
    }
  }
  benchMesh(run);
}

}  // namespace haptiv
