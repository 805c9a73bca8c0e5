#include "haptics/safety/SessionStates.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/haptics/tick/HapticTickFixture.h"

namespace haptiv {
namespace {

using enum SessionState;
using testing::HapticTickTest;
using testing::readingOf;
using testing::released;

/// A session after these inputs, nothing being wrong.
SessionStates after(std::vector<std::uint16_t> inputs, SessionStates session = {}) {
  for (const std::uint16_t each : inputs) session = next(session, each, kNoFault);
  return session;
}

const SessionStates kRunning = after({0, kInputDeadMan});

TEST(SessionStatesTest, WaitForADeviceThatAnswers) {
  EXPECT_EQ(next({}, 0, kFaultDisconnected).now, idle);
  EXPECT_EQ(next({}, 0, kNoFault).now, ready);
  EXPECT_EQ(next({}, 0, kFaultTripWatchdog).now, fault);
}

TEST(SessionStatesTest, RunWhileTheDeadManIsPressed) {
  EXPECT_EQ(kRunning.now, running);
  EXPECT_EQ(after({kInputDeadMan}, kRunning).now, running);
  EXPECT_EQ(after({0}, kRunning).now, ready);
  EXPECT_EQ(after({0, kInputDeadMan}, kRunning).now, running);
}

TEST(SessionStatesTest, DoNotStartByADeadManThatWasPressedBefore) {
  EXPECT_EQ(after({kInputDeadMan, kInputDeadMan, kInputDeadMan}).now, ready);
  EXPECT_EQ(after({kInputDeadMan, 0, kInputDeadMan}).now, running);
}

TEST(SessionStatesTest, LatchEveryFaultUntilTheReset) {
  for (int bit = 0; bit < kFaultCount; ++bit) {
    for (const SessionStates& from : {after({0}), kRunning}) {
      SessionStates session = next(from, kInputDeadMan, 1u << bit);
      EXPECT_EQ(session.now, fault);
      session = after({0, kInputDeadMan, 0}, session);
      EXPECT_EQ(session.now, fault);
      EXPECT_EQ(session.faults, 1u << bit);
      session = after({kInputReset}, session);
      EXPECT_EQ(session.now, ready);
      EXPECT_EQ(session.faults, kNoFault);
      EXPECT_EQ(after({kInputReset, kInputDeadMan}, session).now, running);
    }
  }
}

TEST(SessionStatesTest, RefuseAResetThatMeansNothing) {
  const SessionStates broken = next(kRunning, kInputDeadMan, kFaultTracking);
  EXPECT_EQ(after({kInputReset | kInputDeadMan}, broken).now, fault);           // the dead-man is pressed
  EXPECT_EQ(next(after({0}, broken), kInputReset, kFaultTracking).now, fault);  // the cause still stands
  const SessionStates jammed = next(kRunning, kInputDeadMan | kInputReset, kFaultTracking);
  EXPECT_EQ(after({kInputReset, kInputReset}, jammed).now, fault);  // the button is jammed
  EXPECT_EQ(after({kInputReset, 0, kInputReset}, jammed).now, ready);
}

TEST(SessionStatesTest, CollectTheFaultsThatFollow) {
  const SessionStates broken = next(next(kRunning, 0, kFaultTracking), 0, kFaultDisconnected);
  EXPECT_EQ(broken.faults, kFaultTracking | kFaultDisconnected);
}

TEST_F(HapticTickTest, BrakesWithoutForceWhileTheDeadManIsReleased) {
  testing::IdealArm arm(description, start, inTool({20, 0, 0}));  // against the wall
  arm.start(1 / testing::kRate);
  TickState state;
  TickRecord record;
  for (int i = 0; i < 400; ++i) {
    record = tick(scene, arm.read(), state);
    arm.write(record.command);
  }
  EXPECT_EQ(record.state, running);
  EXPECT_GT(record.environmentForce.norm(), 1);
  record = tick(scene, released(arm.read()), state);
  EXPECT_EQ(record.state, SessionState::ready);
  EXPECT_EQ(record.faults, kNoFault);
  EXPECT_FALSE(record.command.enabled);
  EXPECT_EQ(record.command.jointRates, JointVector(JointVector::Zero()));
  EXPECT_EQ(record.environmentForce, Vector3::Zero());
}

TEST_F(HapticTickTest, StartsSoftlyAgainWhereTheArmIsThen) {
  TickState state = ready();
  for (int i = 0; i < 20; ++i) tick(scene, readingOf(description, start), state);
  JointVector elsewhere = start;
  for (int i = 0; i < 50; ++i) {  // the arm is pushed on while it brakes
    elsewhere[3] += 0.002;
    EXPECT_EQ(tick(scene, released(readingOf(description, elsewhere)), state).faults, kNoFault);
  }
  scene.walls[0].shape.centre.x() -= 0.05;
  computeBounds(scene);
  const TickRecord first = tick(scene, readingOf(description, elsewhere), state);
  EXPECT_EQ(first.state, running);
  EXPECT_EQ(first.environmentForce, Vector3::Zero());
  EXPECT_EQ(first.desiredVelocity, Vector3::Zero());
  EXPECT_EQ(first.desiredPosition, first.position);
  EXPECT_EQ(first.desiredAngles, first.jointAngles);
  Vector3 last = Vector3::Zero();
  for (int i = 0; i < 12; ++i) {  // before it is noticed that this arm does not follow
    const TickRecord record = tick(scene, readingOf(description, elsewhere), state);
    ASSERT_EQ(record.faults, kNoFault);
    EXPECT_LT((record.environmentForce - last).norm(), 5);
    last = record.environmentForce;
  }
  EXPECT_GT(last.norm(), 1);
}

TEST_F(HapticTickTest, GoesOnAfterAFaultOnlyByResetAndAFreshPress) {
  TickState state = ready();
  tick(scene, readingOf(description, start), state);
  DeviceReading stopped = readingOf(description, start);
  stopped.inputs |= kInputEmergencyStop3;
  EXPECT_EQ(tick(scene, stopped, state).faults, kFaultEmergencyStop);
  EXPECT_EQ(tick(scene, readingOf(description, start), state).state, fault);
  DeviceReading reset = released(readingOf(description, start));
  reset.inputs = kInputReset;
  EXPECT_EQ(tick(scene, reset, state).state, SessionState::ready);
  EXPECT_FALSE(tick(scene, reset, state).command.enabled);
  const TickRecord again = tick(scene, readingOf(description, start), state);
  EXPECT_EQ(again.state, running);
  EXPECT_TRUE(again.command.enabled);
}

}  // namespace
}  // namespace haptiv
