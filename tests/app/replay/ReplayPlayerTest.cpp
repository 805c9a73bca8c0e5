#include "app/replay/ReplayPlayer.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "tests/app/replay/TestLog.h"

namespace haptiv {
namespace {

TEST(ReplayPlayer, FindsTheTickBeforeTheCursorWhereSomeWereMissed) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(3'000, [](std::uint64_t tick) { return tick > 1'000 && tick < 2'000; })));
  player.seek(0.5);
  EXPECT_EQ(player.record().tick, 500u);
  EXPECT_EQ(player.record().reading.encoderCounts[0], 500);
  player.seek(1.7);
  EXPECT_EQ(player.record().tick, 1'000u);
  player.seek(2.0);
  EXPECT_EQ(player.record().tick, 2'000u);
  EXPECT_EQ(player.index(), 1'001u);
}

TEST(ReplayPlayer, StaysWithinTheLog) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(1'001)));
  EXPECT_DOUBLE_EQ(player.duration(), 1.0);
  player.seek(99);
  EXPECT_EQ(player.time(), player.duration());
  EXPECT_EQ(player.record().tick, 1'000u);
  player.seek(-1);
  EXPECT_EQ(player.time(), 0);
  EXPECT_EQ(player.record().tick, 0u);
}

TEST(ReplayPlayer, StepsFromTickToTickOverMissedOnes) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(100, [](std::uint64_t tick) { return tick == 11 || tick == 12; })));
  player.seek(0.010);
  player.step(1);
  EXPECT_EQ(player.record().tick, 13u);
  player.step(-1);
  EXPECT_EQ(player.record().tick, 10u);
  player.step(-50);
  EXPECT_EQ(player.record().tick, 0u);
}

TEST(ReplayPlayer, PlaysToTheEndAndStopsThere) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(301)));
  const QSignalSpy times(&player, &ReplayPlayer::timeChanged);
  const QSignalSpy playing(&player, &ReplayPlayer::playingChanged);
  player.play();
  EXPECT_TRUE(player.isPlaying());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !player.isPlaying(); }, kLongEnough));
  EXPECT_EQ(player.time(), player.duration());
  EXPECT_EQ(player.record().tick, 300u);
  for (int i = 1; i < times.size(); ++i) EXPECT_GE(times[i][0].toDouble(), times[i - 1][0].toDouble());
  ASSERT_EQ(playing.size(), 2);
  EXPECT_TRUE(playing[0][0].toBool());
  EXPECT_FALSE(playing[1][0].toBool());
}

TEST(ReplayPlayer, StartsOverWhenPlayedAtTheEnd) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(60'000)));
  player.seek(player.duration());
  player.play();
  EXPECT_TRUE(player.isPlaying());
  EXPECT_LT(player.time(), player.duration());
}

TEST(ReplayPlayer, StaysWhereItIsWhilePaused) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(60'000)));
  player.play();
  ASSERT_TRUE(QTest::qWaitFor([&] { return player.time() > 0; }, kLongEnough));
  player.pause();
  const double time = player.time();
  QTest::qWait(100);
  EXPECT_EQ(player.time(), time);
}

TEST(ReplayPlayer, GoesFartherInTheSameTimeAtAHigherSpeed) {
  TestLogs logs;
  ReplayPlayer slow(logs.make(testTicks(120'000)));
  ReplayPlayer fast(logs.make(testTicks(120'000)));
  slow.setSpeed(0.1);
  fast.setSpeed(10);
  slow.play();
  fast.play();
  // Both see the same clock: a hundredfold difference leaves room for any scheduling.
  ASSERT_TRUE(QTest::qWaitFor([&] { return slow.time() > 0 && fast.time() > 0.5; }, kLongEnough));
  EXPECT_GT(fast.time(), slow.time());
}

TEST(ReplayPlayer, DoesNotJumpWhenTheSpeedChanges) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(120'000)));
  player.setSpeed(0.1);
  player.seek(60);
  player.play();
  ASSERT_TRUE(QTest::qWaitFor([&] { return player.time() > 60; }, kLongEnough));
  player.setSpeed(10);
  const double time = player.time();
  EXPECT_GE(time, 60);
  ASSERT_TRUE(QTest::qWaitFor([&] { return player.time() > time; }, kLongEnough));
  EXPECT_EQ(player.speed(), 10);
}

TEST(ReplayPlayer, BoundsTheSpeed) {
  TestLogs logs;
  ReplayPlayer player(logs.make(testTicks(10)));
  player.setSpeed(1000);
  EXPECT_EQ(player.speed(), 10);
  player.setSpeed(0);
  EXPECT_EQ(player.speed(), 0.1);
}

TEST(ReplayPlayer, AnnouncesAnotherSceneOnceAndWithItsTick) {
  TestLogs logs;
  auto ticks = testTicks(3'000);
  for (TickRecord& tick : ticks) tick.sceneVersion = tick.tick < 1'000 ? 0 : tick.tick < 2'000 ? 1 : 4;
  ReplayPlayer player(logs.make(ticks));
  std::vector<std::string> announced;
  QObject::connect(&player, &ReplayPlayer::sceneChanged, [&] {
    EXPECT_EQ(player.scene().scene.version, player.record().sceneVersion);
    announced.push_back(player.scene().text);
  });
  EXPECT_EQ(player.scene().text, "scene 0");
  for (const double time : {0.5, 1.5, 1.6, 2.5, 0.1}) player.seek(time);
  EXPECT_EQ(announced, (std::vector<std::string>{"scene 1", "scene 4", "scene 0"}));
}

TEST(ReplayPlayer, DoesNothingWithALogWithoutTicks) {
  TestLogs logs;
  ReplayPlayer player(logs.make({}));
  player.play();
  player.seek(1);
  player.step(1);
  EXPECT_FALSE(player.isPlaying());
  EXPECT_EQ(player.time(), 0);
}

}  // namespace
}  // namespace haptiv
