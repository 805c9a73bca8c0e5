#pragma once

#include <Eigen/Core>
#include <cmath>

namespace haptiv {

/// A = L L^T of a small symmetric positive definite matrix, written out: Eigen's LLT gives the same bits, and takes
/// ten times as long to compile, for it holds the blocked products of large matrices too.
/// Realtime-safe: yes.  Where A is not positive definite, the factors are those of its leading part that is.
template <int N>
class Cholesky {
 public:
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  Cholesky() noexcept = default;
  explicit Cholesky(const Matrix& A) noexcept : L_(A) {
    for (int k = 0; k < N; ++k) {
      const double square = L_(k, k) - along(k, k, k);
      if (square <= 0) return;
      L_(k, k) = std::sqrt(square);
      for (int i = k + 1; i < N; ++i) L_(i, k) = (L_(i, k) - along(i, k, k)) / L_(k, k);
    }
  }

  /// x with A x = b.
  Vector solve(const Vector& b) const noexcept {
    Vector x = b;
    for (int i = 0; i < N; ++i) x[i] = (x[i] - before(i, 0, i, x)) / L_(i, i);
    for (int i = N - 1; i >= 0; --i) x[i] = (x[i] - after(i, x)) / L_(i, i);
    return x;
  }

  /// Square root of A's determinant.
  double rootOfDeterminant() const noexcept { return product(0, N); }

 private:
  /// Of rows i and k, the first `length` entries.
  double along(int i, int k, int length) const noexcept {
    double total = 0;
    for (int j = 0; j < length; ++j) total += L_(i, j) * L_(k, j);
    return total;
  }
  // Sums and products are halved, or taken in pairs, as Eigen does: logs replay bit for bit, whatever wrote them.

  /// sum of L_ij x_j, from <= j < to.
  double before(int i, int from, int to, const Vector& x) const noexcept {
    if (to - from < 2) return to > from ? L_(i, from) * x[from] : 0;
    const int middle = from + (to - from) / 2;
    return before(i, from, middle, x) + before(i, middle, to, x);
  }
  /// sum of L_ji x_j, j > i.
  double after(int i, const Vector& x) const noexcept {
    double first = 0, second = 0;
    int j = i + 1;
    for (; j + 1 < N; j += 2) {
      first += L_(j, i) * x[j];
      second += L_(j + 1, i) * x[j + 1];
    }
    const double pairs = first + second;
    return j < N ? pairs + L_(j, i) * x[j] : pairs;
  }
  double product(int from, int to) const noexcept {
    if (to - from == 1) return L_(from, from);
    const int middle = from + (to - from) / 2;
    return product(from, middle) * product(middle, to);
  }

  Matrix L_;  ///< below and on the diagonal
};

}  // namespace haptiv
