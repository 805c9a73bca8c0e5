#pragma once

#include <functional>
#include <vector>

#include "app/devicecheck/PoseFigures.h"
#include "device/control/ResolutionChoice.h"

namespace haptiv {

/// How finely the workspace is gone through.
struct TourGrid {
  int layers = 7;             ///< heights at which the whole disc is swept, the lowest and the highest included; odd
  double lines = 0.05;        ///< between the lines of a sweep, and between the places on them [m]
  int turnLayers = 3;         ///< heights at which the tool is turned
  double turnRings = 0.2125;  ///< between the rings of places at which it is turned [m]
  int turnPlaces = 8;         ///< on each ring
};

/// One of the poses that the arm came through.
struct TourSample {
  JointVector q = JointVector::Zero();
  Vector3 position = Vector3::Zero();  ///< p_BT, where the tool was to be [m]
  double placeError = 0;               ///< [m]
  double turnError = 0;                ///< [rad]
  bool onGrid = false;                 ///< at a place of a sweep
  PoseFigures figures;
};

struct Tour {
  std::vector<TourSample> samples;
  int places = 0;        ///< at which the tool was to be, or to be turned
  int placesMissed = 0;  ///< to which the arm did not come, or where it could not turn the tool
};

/// Goes through the specification's cylinder at 1 m/s from the description's home, by the solver that a session uses:
/// every layer line by line, the orientation held; and ring by ring, where at each place the tool is turned once about
/// each axis of B. Where the arm does not get on, it starts anew from home, for the next place; after
/// a dozen in a row the rest of that part is missed.
/// @param progress  is called after each of `tourParts` parts; null: nobody asks
/// The same arguments give the same bits, however many threads there are.
Tour tourWorkspace(const DeviceDescription& device, const ResolutionChoice& choice, const Specification& specification,
                   const TourGrid& grid, const std::function<void()>& progress);

/// How often `progress` will be called.
int tourParts(const TourGrid& grid);

}  // namespace haptiv
