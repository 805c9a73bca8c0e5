#pragma once

#include <string>

#include "app/experiments/RunResult.h"

namespace haptiv {

/// A run as a table, one row a sample; SI units:
///   t_s, q1..q10 [rad], index_trans, index_rot, sigma_min_rot, sigma_min_trans, condition_trans, condition_rot,
///   phi_rad (along the path), position_error_m, orientation_error_rad, qd1..qd10 [rad/s]
/// The same run gives the same bytes on every machine of one kind; no locale is asked.
std::string toCsv(const RunResult& result);

}  // namespace haptiv
