#pragma once

#include <array>
#include <cmath>

#include "haptics/index/BoxNode.h"

namespace haptiv {

/// The way of a ball along a straight line, against boxes: none that it touches is missed.
class SweptBall {
 public:
  /// All seen from the tree's origin [m].
  SweptBall(const Vector3& from, const Vector3& to, double reach, double slack) noexcept
      : middle_(0.5 * from + 0.5 * to), half_((0.5 * to - 0.5 * from).cwiseAbs()), step_(0.5 * to - 0.5 * from) {
    reach_ = reach + slack;
    isLong_ = half_.maxCoeff() > reach_;
  }

  /// Whether the box at a place of a node may be touched, once its extent along the axes says so. The rest of the
  /// separating axes of a line and a box grown by the reach: those across the line.
  bool mayTouch(const BoxNode& node, std::size_t place) const noexcept {
    if (!isLong_) return true;
    Vector3 extent, between;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      const double low = node.low[axis][place];
      const double high = node.high[axis][place];
      extent[k] = 0.5 * (high - low) + reach_;
      between[k] = 0.5 * (high + low) - middle_[k];
    }
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Index j = (i + 1) % 3;
      const double across = std::abs(between[i] * step_[j] - between[j] * step_[i]);
      const double allowed = extent[i] * half_[j] + extent[j] * half_[i];
      const double slack = 1e-12 * (std::abs(between[i]) * half_[j] + std::abs(between[j]) * half_[i] + allowed);
      if (across > allowed + slack) return false;
    }
    return true;
  }

 private:
  Vector3 middle_;
  Vector3 half_;
  Vector3 step_;
  double reach_;
  bool isLong_;
};

}  // namespace haptiv
