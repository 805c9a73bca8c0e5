#include "app/devicecheck/WorkspaceTour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <thread>

#include "app/devicecheck/ArmMover.h"
#include "device/dynamics/ArmDynamics.h"

namespace haptiv {
namespace {

constexpr int kSampleTicks = 10;  // a centimetre, or 31 mrad
constexpr int kMostMissed = 12;   // places in a row, and the rest of the way is given up

double heightOf(int layer, int layers, double height) {
  return layers < 2 ? 0 : height * (static_cast<double>(layer) / (layers - 1) - 0.5);
}

/// Line by line along x, to and fro, over the disc.
std::vector<Vector3> sweepOf(double radius, double spacing, double z) {
  std::vector<Vector3> places;
  const int lines = static_cast<int>(std::floor(radius / spacing + 1e-9));
  for (int row = -lines; row <= lines; ++row) {
    const double y = row * spacing;
    const int half = static_cast<int>(std::floor(std::sqrt(std::max(0., radius * radius - y * y)) / spacing + 1e-9));
    const int sense = row % 2 == 0 ? 1 : -1;
    for (int column = -half; column <= half; ++column) places.emplace_back(sense * column * spacing, y, z);
  }
  return places;
}

/// From the middle outwards, ring by ring.
std::vector<Vector3> ringsOf(double radius, double spacing, int perRing, double z) {
  std::vector<Vector3> places = {{0, 0, z}};
  for (double r = spacing; r < radius * (1 + 1e-9); r += spacing) {
    for (int i = 0; i < perRing; ++i) {
      const double angle = 2 * std::numbers::pi * i / perRing;
      places.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  }
  return places;
}

/// A way through part of the workspace, from home.
struct Journey {
  std::vector<Vector3> places;
  bool turns = false;
};

class Traveller {
 public:
  Traveller(const DeviceDescription& device, const ArmKinematics& arm, const RedundancyResolution& resolution,
            const ResolutionChoice& choice, const Specification& specification)
      : device_(device), specification_(specification), mover_(device, arm, resolution, choice) {
    if (!device.bodies.links.empty()) dynamics_.emplace(device);
  }

  Tour go(const Journey& journey) {
    tour_.places = static_cast<int>(journey.places.size());
    int missed = 0;  // one after the other
    int visited = 0;
    for (int i = 0; i < tour_.places && missed < kMostMissed; ++i) {
      ticks_ = 0;
      const bool came = mover_.moveTo(journey.places[i], sampling()) && isThere();
      take(came && !journey.turns);
      missed = came && (!journey.turns || turnEachWay()) ? 0 : missed + 1;
      if (missed == 0) ++visited;
      if (!came) mover_.goHome();
    }
    tour_.placesMissed = tour_.places - visited;
    return std::move(tour_);
  }

 private:
  ArmMover::Visit sampling() {
    return [this](const JointVector& q, const ArmPose& actual, const Pose& wanted) {
      newest_ = {q,
                 wanted.position,
                 (actual.X_BT.position - wanted.position).norm(),
                 Eigen::AngleAxisd(Matrix3(actual.X_BT.rotation * wanted.rotation.transpose())).angle(),
                 false,
                 {}};
      pose_ = actual;
      if (++ticks_ % kSampleTicks == 0) take(false);
    };
  }

  bool isThere() const {
    return newest_.placeError <= specification_.placeError && newest_.turnError <= specification_.turnError;
  }

  void take(bool onGrid) {
    newest_.onGrid = onGrid;
    const JointVector weight = dynamics_ ? dynamics_->gravity(newest_.q) : JointVector(JointVector::Zero());
    newest_.figures = figuresOf(pose_, weight, device_, specification_);
    tour_.samples.push_back(newest_);
  }

  /// Each turn starts from the posture in which the arm came here.
  bool turnEachWay() {
    const ArmMover here = mover_;
    bool good = true;
    for (int axis = 0; axis < 3; ++axis) {
      mover_ = here;
      good = mover_.turnAbout(Vector3::Unit(axis), sampling()) && isThere() && good;
    }
    mover_ = here;
    return good;
  }

  const DeviceDescription& device_;
  const Specification& specification_;
  std::optional<ArmDynamics> dynamics_;  // nothing where the links' masses are not known
  ArmMover mover_;
  Tour tour_;
  TourSample newest_;
  ArmPose pose_;
  int ticks_ = 0;
};

std::vector<Journey> journeysOf(const Specification& specification, const TourGrid& grid) {
  const double radius = specification.diameter / 2;
  std::vector<Journey> journeys;
  for (int layer = 0; layer < grid.turnLayers; ++layer)  // the longest first
    journeys.push_back(
        {ringsOf(radius, grid.turnRings, grid.turnPlaces, heightOf(layer, grid.turnLayers, specification.height)),
         true});
  for (int layer = 0; layer < grid.layers; ++layer)
    journeys.push_back({sweepOf(radius, grid.lines, heightOf(layer, grid.layers, specification.height)), false});
  return journeys;
}

}  // namespace

int tourParts(const TourGrid& grid) {
  return grid.layers + grid.turnLayers;
}

Tour tourWorkspace(const DeviceDescription& device, const ResolutionChoice& choice, const Specification& specification,
                   const TourGrid& grid, const std::function<void()>& progress) {
  const ArmKinematics arm(device);
  const RedundancyResolution resolution(device);
  const std::vector<Journey> journeys = journeysOf(specification, grid);
  std::vector<Tour> parts(journeys.size());
  std::atomic<std::size_t> next = 0;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t i = next++; i < journeys.size(); i = next++) {
      parts[i] = Traveller(device, arm, resolution, choice, specification).go(journeys[i]);
      const std::lock_guard lock(telling);
      if (progress) progress();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::min(16U, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
    work();
  }
  Tour whole;
  for (const Tour& part : parts) {
    whole.samples.insert(whole.samples.end(), part.samples.begin(), part.samples.end());
    whole.places += part.places;
    whole.placesMissed += part.placesMissed;
  }
  return whole;
}

}  // namespace haptiv
