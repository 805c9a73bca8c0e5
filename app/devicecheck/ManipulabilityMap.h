#pragma once

#include "app/devicecheck/WorkspaceTour.h"
#include "app/figures/Figure.h"

namespace haptiv {

/// The dexterity indices V / kappa, eq. (14), of translation and rotation over the lowest, the middle and the highest
/// layer of a tour, as the arm came through them.
Figure manipulabilityMap(const Tour& tour, const TourGrid& grid, const Specification& specification,
                         const std::string& title);

}  // namespace haptiv
