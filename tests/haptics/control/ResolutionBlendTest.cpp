#include "haptics/control/ResolutionBlend.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/haptics/tick/HapticTickFixture.h"

namespace haptiv {
namespace {

using testing::HapticTickTest;
using testing::IdealArm;
using testing::kRate;

class ResolutionBlendTest : public HapticTickTest {
 protected:
  static constexpr ResolutionChoice kChoices[] = {{Strategy::nonopt, Solution::full},
                                                  {Strategy::cond, Solution::full},
                                                  {Strategy::dir, Solution::partitioned},
                                                  {Strategy::man, Solution::full}};

  /// A second of each choice, the hand pushing gently.
  std::vector<TickRecord> runThroughAllChoices() const {
    IdealArm arm(description, start, inTool({0.1, 0.05, -0.05}));
    const HapticTick itsTick(description, 1 / kRate);
    HapticScene empty;
    TickState state;
    std::vector<TickRecord> records;
    arm.start(1 / kRate);
    for (const ResolutionChoice& choice : kChoices) {
      empty.resolution = choice;
      for (int i = 0; i < 1000; ++i) {
        records.push_back(itsTick(empty, arm.read(), state));
        arm.write(records.back().command);
      }
    }
    return records;
  }
};

TEST_F(ResolutionBlendTest, LetsRatesGoFromOneChoiceToTheNextWithoutAStep) {
  const std::vector<TickRecord> records = runThroughAllChoices();
  double fastest = 0, step = 0;
  for (std::size_t i = 1; i < records.size(); ++i) {
    ASSERT_EQ(records[i].faults, kNoFault);
    const JointVector difference = records[i].command.jointRates - records[i - 1].command.jointRates;
    step = std::max(step, difference.cwiseAbs().maxCoeff());
    fastest = std::max(fastest, records[i].command.jointRates.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(fastest, 0.5);  // self-motion there was
  EXPECT_LT(step, 0.05);  // 4 rad/s spread over half a second are 0.008 a tick; an encoder count times the gain 0.0006
}

TEST_F(ResolutionBlendTest, IsNotFeltByTheHand) {
  for (const TickRecord& record : runThroughAllChoices()) {
    EXPECT_LT((record.position - record.desiredPosition).norm(), 1e-3);
  }
}

TEST_F(ResolutionBlendTest, FinishesOneChangeBeforeTheNext) {
  const RedundancyResolution resolution(description);
  const Jacobian J = Vishard10(description.links).jacobian(start);
  ResolutionBlend blend;
  const auto rates = [&](const ResolutionChoice& wanted) {
    return blend.rates(resolution, wanted, start, J, Vector6::Zero(), 1 / kRate);
  };
  rates(kChoices[1]);
  for (int i = 0; i < 100; ++i) rates(kChoices[3]);
  EXPECT_EQ(blend.to, kChoices[1]);
  for (int i = 0; i < 1000; ++i) rates(kChoices[3]);
  EXPECT_EQ(blend.to, kChoices[3]);
  EXPECT_EQ(rates(kChoices[3]), resolution.rates(kChoices[3], start, J, Vector6::Zero(), 1 / kRate));
}

}  // namespace
}  // namespace haptiv
