#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/app/commands/HaptivProgram.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;
using Angles = std::array<double, 10>;

constexpr double kExact = 1e-12;  // rounding of a few sines and products

Json kinematics(const Angles& q) {
  std::string list;
  for (const double angle : q) list += (list.empty() ? "" : ",") + Json(angle).dump();
  const Ended ended = runHaptiv({"kinematics", "--q", list, "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  return ended.json();
}

}  // namespace

TEST(Kinematics, AtZeroTheArmIsStretchedAndTheRotationIsTheIdentity) {
  const Json pose = kinematics({});
  EXPECT_NEAR(pose["position_m"][0], 1.0, kExact);
  EXPECT_NEAR(pose["position_m"][1], 0.0, kExact);
  EXPECT_NEAR(pose["position_m"][2], 0.424, kExact);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) EXPECT_NEAR(pose["rotation"][row][column], row == column, kExact);
  EXPECT_NEAR(pose["sigma_min_rot"], 0.0, 1e-6);  // only axes x and z turn: singular
}

TEST(Kinematics, ItsJacobianIsTheSlopeOfItsPosition) {
  const Angles q = {-0.4, 0.7, 0.5, -0.9, 0.3, 2.0, 1.1, 0.6, -1.2, 0.8};
  const double step = 1e-4;  // error of a central difference: step^2 / 6 m, 2e-9
  const Json jacobian = kinematics(q)["jacobian"];
  ASSERT_EQ(jacobian.size(), 6u);
  for (int joint = 0; joint < 10; ++joint) {
    Angles more = q, less = q;
    more[joint] += step;
    less[joint] -= step;
    const Json after = kinematics(more)["position_m"], before = kinematics(less)["position_m"];
    for (int row = 0; row < 3; ++row) {
      const double slope = (after[row].get<double>() - before[row].get<double>()) / (2 * step);
      EXPECT_NEAR(jacobian[row][joint], slope, 1e-8) << "joint " << joint + 1;
    }
  }
}

TEST(Kinematics, IndicesAreVolumeOverConditionOfTheBlocks) {
  const Json pose = kinematics({-0.4, 0.7, 0.5, -0.9, 0.3, 2.0, 1.1, 0.6, -1.2, 0.8});
  for (const std::string block : {"trans", "rot"}) {
    const auto sigma = pose["singular_values_" + block].get<std::vector<double>>();
    ASSERT_EQ(sigma.size(), 3u);
    // Singular values against the Jacobian itself: their squares add up to its entries' squares.
    double squares = 0;
    for (int row = block == "rot" ? 3 : 0, end = row + 3; row < end; ++row)
      for (const double entry : pose["jacobian"][row]) squares += entry * entry;
    EXPECT_NEAR(sigma[0] * sigma[0] + sigma[1] * sigma[1] + sigma[2] * sigma[2], squares, 1e-9 * squares);
    // eq. (10) with Gamma(5/2) itself, eqs. (11), (12)
    const double volume = std::pow(std::numbers::pi, 1.5) / std::tgamma(2.5) * sigma[0] * sigma[1] * sigma[2];
    EXPECT_NEAR(pose["index_" + block], volume / (sigma[0] / sigma[2]), 1e-9);
  }
  EXPECT_EQ(pose["sigma_min_rot"], pose["singular_values_rot"][2]);
  EXPECT_EQ(pose["singular_values"].size(), 6u);
}

TEST(Kinematics, StartPoseOfExperimentOneIsWhereThePaperPutsIt) {
  // r = 0.4 m: joint 3 on the positive y side; joints 1..4 close the planar chain at (0.4, 0).
  constexpr double kPi = std::numbers::pi;
  const double l12 = 2 * 0.25 * std::cos(kPi / 8);  // two links with -45 degrees between
  const double half = std::acos(0.4 / 2 / l12);
  const double th1 = half + kPi / 8, th2 = -kPi / 4, th3 = -2 * half + kPi / 4, th4 = -kPi / 4;
  const Json pose = kinematics(
      {th1, th2, th3, th4, kPi / 2 - (th1 + th2 + th3 + th4), 5 * kPi / 6, kPi / 3, 5 * kPi / 6, -3 * kPi / 4, 0});
  EXPECT_NEAR(pose["position_m"][0], 0.4, 1e-9);
  EXPECT_NEAR(pose["position_m"][1], 0.0, 1e-9);
  EXPECT_NEAR(pose["position_m"][2], -0.367, 5e-4);  // as printed
}

TEST(Kinematics, RefusesAnythingButTenNumbers) {
  for (const char* q : {"", "1,2,3", "0,0,0,0,0,0,0,0,0,0,0", "0,0,0,0,x,0,0,0,0,0", "0,0,0,0,nan,0,0,0,0,0",
                        "0,0,0,0,0,0,0,0,0,", "0,0,0,0,1e999,0,0,0,0,0"}) {
    const Ended ended = runHaptiv({"kinematics", "--q", q, "--json"});
    EXPECT_EQ(ended.code, 2) << q;
    EXPECT_THAT(ended.err, HasSubstr("--q")) << q;
    EXPECT_EQ(ended.out, "") << q;
  }
}

TEST(Kinematics, TableForPeopleHasUnits) {
  const Ended ended = runHaptiv({"kinematics", "--q", "-0.5,0,0,0,0,0,0,0,0,0"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("0.424 m"));
}

}  // namespace haptiv
