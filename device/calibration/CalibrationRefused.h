#pragma once

#include <stdexcept>

namespace haptiv {

/// What was measured cannot be calibrated by: what() says why, and what to do. Nothing has been changed.
class CalibrationRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace haptiv
