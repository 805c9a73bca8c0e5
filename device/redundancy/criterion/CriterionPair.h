#pragma once

namespace haptiv {

/// A number each for the translational and the rotational criterion: values, or weights of eq. (15).
struct CriterionPair {
  double translation = 0;
  double rotation = 0;
};

}  // namespace haptiv
