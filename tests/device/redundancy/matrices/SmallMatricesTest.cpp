#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <random>

#include "device/redundancy/matrices/Cholesky.h"
#include "device/redundancy/matrices/SymmetricEigen.h"

namespace haptiv {
namespace {

/// A A^T of a random A; every fourth is nearly singular.
template <int N>
Eigen::Matrix<double, N, N> randomGram(std::mt19937_64& random, int trial) {
  std::normal_distribution<double> number;
  Eigen::Matrix<double, N, N + 1> A;
  for (int i = 0; i < A.size(); ++i) A.data()[i] = number(random);
  if (trial % 4 == 0) A.row(0) *= 1e-7;
  return A * A.transpose();
}

template <typename Size>
class SmallMatrices : public testing::Test {};
using Sizes = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                             std::integral_constant<int, 3>, std::integral_constant<int, 6>>;
TYPED_TEST_SUITE(SmallMatrices, Sizes);

// To the last bit: logs written with Eigen's own factors replay.
TYPED_TEST(SmallMatrices, AreFactoredAndSolvedAsEigenDoes) {
  constexpr int N = TypeParam::value;
  std::mt19937_64 random(N);
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Matrix<double, N, N> A = randomGram<N>(random, trial);
    const Eigen::Matrix<double, N, 1> b = A.row(N - 1).transpose().array().cos();
    const Eigen::LLT<Eigen::Matrix<double, N, N>> eigens(A);
    const Cholesky<N> ours(A);
    ASSERT_EQ(ours.solve(b), eigens.solve(b)) << A;
    ASSERT_EQ(ours.rootOfDeterminant(), eigens.matrixLLT().diagonal().prod()) << A;
  }
}

TYPED_TEST(SmallMatrices, HaveTheEigenvectorsThatEigenFinds) {
  constexpr int N = TypeParam::value;
  std::mt19937_64 random(N);
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Matrix<double, N, N> A = randomGram<N>(random, trial);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> eigens(A);
    const SymmetricEigen<N> ours(A);
    ASSERT_EQ(ours.values, eigens.eigenvalues()) << A;
    ASSERT_EQ(ours.vectors, eigens.eigenvectors()) << A;
  }
}

TEST(SymmetricEigenOfTwo, IsIdentityForZeros) {
  const SymmetricEigen<2> flat(Eigen::Matrix2d::Zero());
  EXPECT_EQ(flat.values, Eigen::Vector2d::Zero());
  EXPECT_EQ(flat.vectors, Eigen::Matrix2d::Identity());
}

}  // namespace
}  // namespace haptiv
