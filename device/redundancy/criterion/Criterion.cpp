#include "device/redundancy/criterion/Criterion.h"

#include <numbers>

#include "device/redundancy/matrices/BlockEigen.h"

namespace haptiv {
namespace {

template <int Rows>
double condition(const Eigen::Matrix<double, Rows, 1>& sigma) noexcept {
  const double largest = sigma[0];
  const double smallest = sigma[Rows - 1];
  return smallest * kLargestCondition > largest ? largest / smallest : kLargestCondition;
}

template <typename Block>
Dexterity dexterityOf(const Block& block) noexcept {
  const Matrix3 gram = block * block.transpose();
  const BlockEigen<3> eigen(gram);
  return {eigen.sigma, eigen.axes};
}

}  // namespace

double ellipsoidVolume(const Eigen::Vector2d& sigma) noexcept {
  return kUnitBall<2> * sigma.prod();
}
double ellipsoidVolume(const Vector3& sigma) noexcept {
  return kUnitBall<3> * sigma.prod();
}

double conditionNumber(const Eigen::Vector2d& sigma) noexcept {
  return condition<2>(sigma);
}
double conditionNumber(const Vector3& sigma) noexcept {
  return condition<3>(sigma);
}

double directionalManipulability(const Eigen::Vector2d& sigma) noexcept {
  return kUnitBall<2> * sigma[1] * sigma[1];
}
double directionalManipulability(const Vector3& sigma) noexcept {
  return kUnitBall<3> * sigma[1] * sigma[2] * sigma[2];
}

Dexterity translationalDexterity(const Jacobian& J) noexcept {
  return dexterityOf(J.topRows<3>());
}
Dexterity rotationalDexterity(const Jacobian& J) noexcept {
  return dexterityOf(J.bottomRows<3>());
}

}  // namespace haptiv
