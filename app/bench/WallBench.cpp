#include <algorithm>
#include <cmath>

#include "app/bench/Benches.h"
#include "app/bench/wall/WallMap.h"

namespace haptiv {
namespace {

/// The stiffest wall of the law that is stable at any damping, and at which.
std::vector<std::pair<std::string, double>> stiffestOf(const WallMap& map, const std::string& grip) {
  double stiffest = 0, damping = 0;
  for (const WallLimit& limit : map.limits) {
    if (limit.variant != WallVariant::law || limit.grip != grip) continue;
    for (std::size_t i = 0; i < limit.stiffness.size(); ++i) {
      const double stable = std::min(limit.stiffness[i], map.stiffness.back());
      if (!(stable > stiffest)) continue;
      stiffest = stable;
      damping = map.damping[i];
    }
  }
  return {{"stiffest_N_per_m", stiffest}, {"at_damping_N_s_per_m", damping}};
}

}  // namespace

void benchWall(BenchRun& run) {
  const BenchSettings& settings = run.settings();
  WallMap map =
      mapWalls(settings.device, settings.rate, settings.net, [&](const std::string& what) { run.tell(what); });
  std::vector<double> times = map.tickNs;
  for (const Grip& grip : kGrips) {
    BenchResult result;
    result.name = std::string("wall/") + grip.name;
    result.n = map.trials / std::size(kGrips);
    result.medianNs = quantile(times, 0.5);
    result.p99Ns = quantile(times, 0.99);
    result.notes = stiffestOf(map, grip.name);
    run.add(result);
  }
  run.keep(std::move(map));
}

}  // namespace haptiv
