#include "app/session/recording/SessionRecorder.h"

#include <gmock/gmock.h>

#include "app/session/log/writing/SessionLogWriter.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using namespace haptiv::testing;

TickRecord touching(std::uint64_t tick) {
  TickRecord record;
  record.tick = tick;
  record.contacts = 1;
  return record;
}

TEST(SessionRecorder, GoesOnSummingUpWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  std::atomic<std::uint64_t> space = 1u << 30;
  auto writer = std::make_unique<SessionLogWriter>(folder / "s.h5", someHeader(),
                                                   [&space](const std::filesystem::path&) { return space.load(); });
  writer->addScene(wallScene(), "");
  RecordRing<TickRecord> ring(8192);
  SessionRecorder recorder(ring, std::move(writer));
  space = 0;
  for (std::uint64_t tick = 0; tick < 600; ++tick) ring.push(touching(tick));
  while (recorder.trouble().empty()) std::this_thread::yield();
  for (std::uint64_t tick = 600; tick < 900; ++tick) ring.push(touching(tick));
  const SessionSummary summary = recorder.stop();
  EXPECT_THAT(recorder.trouble(), HasSubstr("nearly full"));
  EXPECT_EQ(summary.ticks, 900u);
  EXPECT_EQ(summary.contacts, 1u);
  EXPECT_FALSE(SessionLog(folder / "s.h5").complete());
}

TEST(SessionRecorder, CountsWhatTheRingCouldNotTake) {
  const TemporaryFolder folder;
  auto writer = std::make_unique<SessionLogWriter>(folder / "s.h5", someHeader());
  writer->addScene(wallScene(), "");
  RecordRing<TickRecord> ring(8192);
  for (std::uint64_t tick = 0; tick < 8192 + 10; ++tick) ring.push(touching(tick));
  ASSERT_EQ(ring.dropped(), 10u);
  SessionRecorder recorder(ring, std::move(writer));
  const SessionSummary summary = recorder.stop();
  EXPECT_EQ(summary.droppedRecords, 10u);
  EXPECT_EQ(summary.ticks, 8192u + 10u);
  EXPECT_THAT(recorder.trouble(), HasSubstr("10 ticks never reached the log"));
  EXPECT_EQ(SessionLog(folder / "s.h5").dropped(), 10u);
}

/// The recorder is not there for the first five seconds: as if its thread, or the disk, had stalled so long.
TEST(SessionRecorder, LosesNothingWhereItStallsForFiveSecondsAtTheHighestRate) {
  const TemporaryFolder folder;
  auto writer = std::make_unique<SessionLogWriter>(folder / "s.h5", someHeader());
  writer->addScene(wallScene(), "");
  ServoSeams seams(kHighestServoRate);
  const auto ticks = static_cast<std::uint64_t>(5 * kHighestServoRate);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    seams.log.push(touching(tick));
    seams.display.write(touching(tick));  // nobody looks at these either
  }
  EXPECT_EQ(seams.log.dropped(), 0u);
  SessionRecorder recorder(seams.log, std::move(writer));
  EXPECT_EQ(recorder.stop().ticks, ticks);
  EXPECT_EQ(recorder.trouble(), "");
  const SessionLog log(folder / "s.h5");
  EXPECT_TRUE(log.complete());
  EXPECT_EQ(log.tickCount(), ticks);
  EXPECT_TRUE(seams.display.update());
  EXPECT_EQ(seams.display.read().tick, ticks - 1);
}

}  // namespace
}  // namespace haptiv
