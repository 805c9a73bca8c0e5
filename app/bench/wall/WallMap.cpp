#include "app/bench/wall/WallMap.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace haptiv {
namespace {

/// Runs job(0) ... job(count - 1) on all processors; throws what the first of them threw.
void inParallel(std::size_t count, const std::function<void(std::size_t)>& job) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr trouble;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        job(i);
      } catch (...) {
        const std::lock_guard guard(mutex);
        if (!trouble) trouble = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
    work();
  }
  if (trouble) std::rethrow_exception(trouble);
}

/// Touches walls, and keeps the books.
class Trials {
 public:
  Trials(const DeviceDescription& description, double rate) : touch_(description, rate) {}

  /// Thread-safe: yes.
  WallOutcome operator()(const WallTrial& trial) {
    const auto begin = std::chrono::steady_clock::now();
    const WallOutcome outcome = touch_(trial);
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    const std::lock_guard guard(mutex_);
    tickNs_.push_back(took.count() / static_cast<double>(std::max<std::uint64_t>(outcome.ticks, 1)));
    return outcome;
  }
  std::vector<double> tickNs() const { return tickNs_; }

 private:
  WallTouch touch_;
  std::mutex mutex_;
  std::vector<double> tickNs_;
};

/// Near the limit it is a matter of luck whether a trial shakes: stable is what is so with either of two noises.
bool isStable(Trials& trials, WallTrial trial) {
  if (!trials(trial).isStable) return false;
  ++trial.seed;
  return trials(trial).isStable;
}

/// The law at every place of the net.
WallShaking shakingOf(Trials& trials, const WallNet& net, const Grip& grip) {
  const std::size_t columns = net.damping.size();
  const std::size_t places = columns * net.stiffness.size();
  WallShaking shaking{grip.name, std::vector<double>(places), std::vector<char>(places)};
  inParallel(places, [&](std::size_t i) {
    const WallOutcome outcome = trials({WallVariant::law, grip, net.damping[i % columns], net.stiffness[i / columns]});
    shaking.oscillation[i] = outcome.oscillation;
    shaking.stable[i] = outcome.isStable;
  });
  return shaking;
}

/// The first row of a column that is not stable; as many as there are rows where all are.
std::size_t firstUnstable(const WallShaking& shaking, std::size_t column, std::size_t columns) {
  std::size_t row = 0;
  while (row * columns + column < shaking.stable.size() && shaking.stable[row * columns + column]) ++row;
  return row;
}

/// The same, by bisection: a wall that is stiffer than one that shakes is taken to shake too.
std::size_t firstUnstable(Trials& trials, const WallNet& net, WallTrial trial) {
  std::size_t stable = 0, unstable = net.stiffness.size() + 1;  // rows counted from one
  while (unstable - stable > 1) {
    const std::size_t row = (stable + unstable) / 2;
    trial.stiffness = net.stiffness[row - 1];
    (isStable(trials, trial) ? stable : unstable) = row;
  }
  return stable;
}

/// The largest stiffness that is stable, between the rows.
double refined(Trials& trials, const WallNet& net, WallTrial trial, std::size_t unstableRow) {
  if (unstableRow == 0) return 0;
  if (unstableRow == net.stiffness.size()) return INFINITY;
  double stable = net.stiffness[unstableRow - 1], unstable = net.stiffness[unstableRow];
  for (int i = 0; i < net.refinements; ++i) {
    trial.stiffness = std::sqrt(stable * unstable);
    (isStable(trials, trial) ? stable : unstable) = trial.stiffness;
  }
  return stable;
}

}  // namespace

std::vector<double> WallNet::geometric(double first, double last, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first * std::pow(last / first, i / (count - 1.0)));
  return values;
}

WallMap mapWalls(const DeviceDescription& description, double rate, const WallNet& net,
                 const std::function<void(const std::string&)>& tell) {
  Trials trials(description, rate);
  WallMap map;
  map.device = description.name;
  map.rate = rate;
  map.mass = WallTouch::kMass;
  map.control = description.control.choice;
  map.damping = net.damping;
  map.stiffness = net.stiffness;
  for (const Grip& grip : kGrips) {
    tell(std::string("wall: ") + grip.name + " grip, the net");
    map.shaking.push_back(shakingOf(trials, net, grip));
    for (const WallVariant variant : kWallVariants) {
      tell(std::string("wall: ") + grip.name + " grip, limits of " + nameOf(variant));
      WallLimit limit{variant, grip.name, std::vector<double>(net.damping.size())};
      inParallel(net.damping.size(), [&](std::size_t column) {
        const WallTrial trial{variant, grip, net.damping[column], 0};
        const std::size_t row = variant == WallVariant::law
                                    ? firstUnstable(map.shaking.back(), column, net.damping.size())
                                    : firstUnstable(trials, net, trial);
        limit.stiffness[column] = refined(trials, net, trial, row);
      });
      map.limits.push_back(std::move(limit));
    }
  }
  map.tickNs = trials.tickNs();
  map.trials = map.tickNs.size();
  return map;
}

}  // namespace haptiv
