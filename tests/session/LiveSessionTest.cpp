#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "app/session/Resimulation.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using namespace haptiv::testing;

constexpr auto kMoment = std::chrono::milliseconds(100);

TEST(LiveSession, WithEditsResimulatesToTheSameBits) {
  const TemporaryFolder folder;
  SessionSetup setup = setupFor(wallScene());
  setup.liveHand = true;
  setup.log = folder / "s.h5";
  SessionSummary summary;
  {
    Session session(setup);
    session.moveHand(Vector3(0.1, 0.02, 0));
    HapticScene edited = wallScene();
    for (int edit = 1; edit <= 4; ++edit) {
      std::this_thread::sleep_for(kMoment);
      edited.version = static_cast<std::uint32_t>(2 * edit);
      edited.walls[0].surface.stiffness = 1000 + 500 * edit;
      edited.walls[0].shape.centre.y() = 0.05 * edit;
      computeBounds(edited);
      session.publish(std::make_shared<const HapticScene>(edited), "edit " + std::to_string(edit));
    }
    session.moveHand(std::nullopt);
    std::this_thread::sleep_for(kMoment);
    summary = session.stop();
    EXPECT_EQ(session.logTrouble(), "");
  }
  const SessionLog log(folder / "s.h5");
  EXPECT_TRUE(log.complete());
  EXPECT_EQ(log.tickCount(), summary.ticks - summary.droppedRecords);
  EXPECT_GT(log.tickCount(), 0u);
  ASSERT_EQ(log.scenes().size(), 5u);
  EXPECT_EQ(log.scenes()[4].text, "edit 4");
  EXPECT_EQ(log.header().startUtc.size(), 20u);
  EXPECT_FALSE(log.header().scheduling.empty());
  EXPECT_TRUE(sameRecord(log.ticks(log.tickCount() - 1, 1).at(0), summary.last));
  EXPECT_EQ(summary.last.sceneVersion, 8u);
  const Verification result = verify(log);
  EXPECT_TRUE(result.identical()) << result.first->field << " at tick " << result.first->tick << ": "
                                  << result.first->logged << " and " << result.first->resimulated;
  EXPECT_EQ(result.ticks, log.tickCount());
}

/// By this the window knows whether the log keeps up with its edits.
TEST(LiveSession, TellsWhatIsStillToBeLoggedUntilItIs) {
  Session session(setupFor(wallScene()));
  EXPECT_EQ(session.shapesToLog(), 0u);
  HapticScene large = wallScene();
  large.version = 2;
  large.walls.resize(5000, large.walls[0]);
  computeBounds(large);
  for (int edit = 0; edit < 3; ++edit) session.publish(std::make_shared<const HapticScene>(large), "");
  EXPECT_EQ(session.shapesToLog() % 5000, 0u);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (session.shapesToLog() > 0 && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(kMoment);
  EXPECT_EQ(session.shapesToLog(), 0u);
}

TEST(LiveSession, KeepsItsDeviceItsHomeAndRisingVersions) {
  Session session(setupFor(wallScene()));
  HapticScene moved = wallScene();
  moved.device.position = Vector3(0, 0, 1);
  moved.tool.home = Vector3(0.1, 0, 0);
  moved.tool.mass = 3;
  const auto taken = session.publish(std::make_shared<const HapticScene>(moved), "");
  EXPECT_EQ(taken->version, 1u);
  EXPECT_EQ(taken->device.position, Vector3(-0.35, 0, 0));
  EXPECT_EQ(taken->tool.home, Vector3(0, 0, 0));
  EXPECT_EQ(taken->tool.mass, 3);
  HapticScene fine = wallScene();
  fine.version = 5;
  const auto scene = std::make_shared<const HapticScene>(fine);
  EXPECT_EQ(session.publish(scene, ""), scene);
  fine.tool.damping = std::nan("");
  EXPECT_THROW(session.publish(std::make_shared<const HapticScene>(fine), ""), std::runtime_error);
}

TEST(LiveSession, AStrategyChosenLiveIsLoggedKeptThroughEditsAndNotFelt) {
  const TemporaryFolder folder;
  SessionSetup setup = setupFor(wallScene());
  setup.liveHand = true;
  setup.log = folder / "s.h5";
  const ResolutionChoice first{Strategy::dir, Solution::full}, second{Strategy::cond, Solution::partitioned};
  {
    Session session(setup);
    session.moveHand(Vector3(0.1, 0.02, 0));
    std::this_thread::sleep_for(4 * kMoment);
    session.chooseResolution(first);
    std::this_thread::sleep_for(2 * kMoment);
    session.publish(std::make_shared<const HapticScene>(wallScene()), "edited");
    session.chooseResolution(second);
    session.chooseResolution(second);  // nothing new
    std::this_thread::sleep_for(2 * kMoment);
    session.stop();
  }
  const SessionLog log(folder / "s.h5");
  ASSERT_EQ(log.scenes().size(), 4u);
  EXPECT_EQ(log.scenes()[1].scene.resolution, first);
  EXPECT_EQ(log.scenes()[1].text, setup.sceneText.get()) << "the scene is the same";
  EXPECT_EQ(log.scenes()[2].scene.resolution, first) << "an edit keeps the choice";
  EXPECT_EQ(log.scenes()[3].scene.resolution, second);
  EXPECT_EQ(log.scenes()[3].text, "edited");
  const std::vector<TickRecord> ticks = log.ticks(0, log.tickCount());
  EXPECT_EQ(ticks.back().sceneVersion, 3u);
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    ASSERT_TRUE((ticks[i].command.jointRates.cwiseAbs().array() <= setup.description.drives.rateLimit.array()).all());
    if (ticks[i].sceneVersion == ticks[i - 1].sceneVersion) continue;
    // A tick of the hand's push and the sensor's noise; the force of the wall itself is some 15 N.
    EXPECT_LT((ticks[i].environmentForce - ticks[i - 1].environmentForce).norm(), 0.5) << "at tick " << i;
  }
  EXPECT_TRUE(verify(log).identical());
}

TEST(LiveSession, RefusesASolutionThatTheArmHasNot) {
  SessionSetup setup = setupFor(wallScene());
  setup.description.chain.joints = {ChainJoint{}};
  HapticScene scene = wallScene();
  scene.resolution = ResolutionChoice{Strategy::dir, Solution::partitioned};
  setup.scene = std::make_shared<const HapticScene>(scene);
  EXPECT_THAT(messageOf([&] { Session{setup}; }), HasSubstr("no partitioned solution"));
}

TEST(LiveSession, FollowsTheLiveHandAndStopsTwice) {
  SessionSetup setup = setupFor(zoneScene(Zone::Kind::viscous));
  setup.liveHand = true;
  Session session(setup);
  session.moveHand(Vector3(0, 0.1, 0));
  TickRecord newest;
  for (int i = 0; i < 100 && !(newest.position.y() > 0.02); ++i) {
    std::this_thread::sleep_for(kMoment);
    session.newest(newest);
  }
  EXPECT_GT(newest.position.y(), 0.02);
  const SessionSummary first = session.stop(), second = session.stop();
  EXPECT_GT(first.ticks, 0u);
  EXPECT_EQ(first.ticks, second.ticks);
  EXPECT_TRUE(sameRecord(first.last, second.last));
}

TEST(LiveSession, TellsThatItCannotLog) {
  const TemporaryFolder folder;
  SessionSetup setup = setupFor(wallScene());
  setup.log = folder / "no/s.h5";
  EXPECT_THAT(messageOf([&] { Session{setup}; }), HasSubstr("the folder does not exist"));
  std::filesystem::create_directory(folder / "s.h5");
  setup.log = folder / "s.h5";
  EXPECT_THAT(messageOf([&] { Session{setup}; }), HasSubstr("cannot create the session log"));
}

}  // namespace
}  // namespace haptiv
