#pragma once

#include <cstdint>

namespace haptiv {

/// What the arm's self-motion is used for: the side criterion of eqs. (4), (5).
enum class Strategy : std::uint8_t {
  nonopt,  ///< nothing: rates of least norm, eq. (3)
  man,     ///< volume of the manipulability ellipsoids, eq. (10)
  dir,     ///< volume over condition number, eq. (14)
  cond,    ///< condition number, eq. (11)
};

/// Whether all joints serve all of the motion, or position and orientation are solved apart, eqs. (24), (25).
enum class Solution : std::uint8_t { full, partitioned };

/// How an arm's redundancy is resolved; the operator may choose it anew while a session runs.
struct ResolutionChoice {
  Strategy strategy = Strategy::nonopt;
  Solution solution = Solution::full;
  bool operator==(const ResolutionChoice&) const = default;
};

}  // namespace haptiv
