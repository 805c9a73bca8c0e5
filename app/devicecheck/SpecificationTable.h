#pragma once

#include <string>
#include <vector>

#include "app/devicecheck/WorkspaceTour.h"

namespace haptiv {

/// A line of the specification, held against everything that a tour came through.
struct SpecificationRow {
  std::string property;  ///< "force_N": its unit at the end
  bool atLeast = true;   ///< the limit is the least, not the most that may be
  double limit = 0;
  double worst = 0;
  TourSample where;    ///< the pose of the worst value
  std::string remark;  ///< what there is to say of a row that does not hold

  bool holds() const { return atLeast ? worst >= limit : worst <= limit; }
};

/// Every line of the specification. The tour holds at least one sample.
std::vector<SpecificationRow> judge(const Tour& tour, const Specification& specification,
                                    const DeviceDescription& device);

}  // namespace haptiv
