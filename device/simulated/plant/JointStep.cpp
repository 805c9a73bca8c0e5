#include "device/simulated/plant/JointStep.h"

#include <Eigen/Cholesky>

namespace haptiv {
namespace {

/// As a rule one pass does, two or three where a joint starts, stops or reaches its torque. Where the passes go round
/// in circles, sweeps over the joints one by one bring them nearer, slowly but surely.
constexpr int kPasses = 6;
constexpr int kSweeps = 8;
constexpr int kMostRounds = 12;
constexpr double kStuck = 1e12;  // [kg m^2] on the diagonal of a joint that stands

/// On which straight piece of friction and of its motor's law a joint is.
struct Piece {
  int direction = 0;  ///< of turning; 0: stands
  int clipped = 0;    ///< sign of the torque limit that is reached; 0: none
  bool operator==(const Piece&) const = default;
};
using Pieces = std::array<Piece, kJointCount>;

int sign(double value) noexcept {
  return (value > 0) - (value < 0);
}

class Solver {
 public:
  explicit Solver(const JointStep& step) noexcept : step_(step), A_(step.mass) {
    A_.diagonal() += step.dt * step.viscous;
    right_ = step.mass * step.rates + step.dt * step.load;
  }

  JointVector solve() const noexcept {
    JointVector near = step_.rates;
    for (int round = 0; round < kMostRounds; ++round) {
      Pieces pieces = piecesAt(near);
      for (int pass = 0; pass < kPasses; ++pass) {
        const JointVector w = solveOn(pieces);
        const Pieces found = piecesAt(w);
        if (found == pieces) return w;
        pieces = found;
      }
      for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (int i = 0; i < kJointCount; ++i) near[i] = alone(i, near);
      }
    }
    return near;
  }

 private:
  /// What pushes joint i while it stands and the others turn, over dt [N m s]; its motor and friction left out.
  double push(int i, const JointVector& w) const noexcept { return right_[i] - A_.row(i).dot(w) + A_(i, i) * w[i]; }
  double dry(int i) const noexcept { return step_.dt * step_.coulomb[i]; }

  Pieces piecesAt(const JointVector& w) const noexcept {
    Pieces pieces;
    for (int i = 0; i < kJointCount; ++i) {
      const TorqueLaw& law = step_.law[static_cast<std::size_t>(i)];
      const double torque = law.offset - law.slope * w[i];
      Piece& piece = pieces[static_cast<std::size_t>(i)];
      piece.clipped = (torque > law.limit) - (torque < -law.limit);
      piece.direction = turning(i, push(i, w) + step_.dt * law.at(0));
    }
    return pieces;
  }
  /// Which way a joint turns that is pushed so, if it does.
  int turning(int i, double pushed) const noexcept { return std::abs(pushed) <= dry(i) ? 0 : sign(pushed); }

  JointVector solveOn(const Pieces& pieces) const noexcept {
    JointMatrix A = A_;
    JointVector b = right_;
    for (int i = 0; i < kJointCount; ++i) {
      const TorqueLaw& law = step_.law[static_cast<std::size_t>(i)];
      const Piece& piece = pieces[static_cast<std::size_t>(i)];
      if (piece.direction == 0) A(i, i) += kStuck;
      if (piece.clipped == 0) A(i, i) += step_.dt * law.slope;
      b[i] += step_.dt * (piece.clipped == 0 ? law.offset : piece.clipped * law.limit) - piece.direction * dry(i);
    }
    JointVector w = A.llt().solve(b);
    for (int i = 0; i < kJointCount; ++i) {
      if (pieces[static_cast<std::size_t>(i)].direction == 0) w[i] = 0;
    }
    return w;
  }

  /// The rate of joint i if those of the others stay.
  double alone(int i, const JointVector& w) const noexcept {
    const TorqueLaw& law = step_.law[static_cast<std::size_t>(i)];
    const double pushed = push(i, w);
    const int direction = turning(i, pushed + step_.dt * law.at(0));
    if (direction == 0) return 0;
    const double rest = pushed - direction * dry(i);
    const double free = (rest + step_.dt * law.offset) / (A_(i, i) + step_.dt * law.slope);
    const double torque = law.at(free);
    return torque == law.offset - law.slope * free ? free : (rest + step_.dt * torque) / A_(i, i);
  }

  const JointStep& step_;
  JointMatrix A_;
  JointVector right_;
};

}  // namespace

JointVector JointStep::solve() const noexcept {
  return Solver(*this).solve();
}

}  // namespace haptiv
