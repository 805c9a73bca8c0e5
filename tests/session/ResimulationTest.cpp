#include "app/session/Resimulation.h"

#include <gmock/gmock.h>

#include <thread>

#include "app/session/log/writing/SessionLogWriter.h"
#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"
#include "haptics/servo/FastLoop.h"
#include "haptics/servo/SessionStart.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using namespace haptiv::testing;

/// A fast run against the wall, and copies of its log in which something was changed.
class Resimulation : public ::testing::Test {
 protected:
  Resimulation() {
    SessionSetup setup = setupFor(wallScene(), {{0, Vector3::Zero()}, {0.5, Vector3(0.1, 0.02, 0)}});
    setup.log = folder_ / "s.h5";
    runFast(setup, 2);
  }

  Verification verifyWith(const std::vector<TickRecord>& ticks, std::uint64_t dropped = 0) {
    const SessionLog log(folder_ / "s.h5");
    {
      SessionLogWriter writer(folder_ / "changed.h5", log.header());
      for (const LoggedScene& scene : log.scenes()) writer.addScene(scene.scene, scene.text);
      writer.append(ticks);
      writer.close(dropped);
    }
    return verify(SessionLog(folder_ / "changed.h5"));
  }
  std::vector<TickRecord> ticks() { return SessionLog(folder_ / "s.h5").ticks(0, 10'000); }

  TemporaryFolder folder_;
};

TEST_F(Resimulation, OfAFastRunGivesTheSameBits) {
  const Verification result = verify(SessionLog(folder_ / "s.h5"));
  EXPECT_TRUE(result.identical()) << result.first->field << " at " << result.first->tick;
  EXPECT_EQ(result.ticks, 2000u);
}

/// The simulated arm with a clock of its own, of whose readings some do not come.
class LossyDevice : public HapticDevice {
 public:
  explicit LossyDevice(const HapticScene& scene)
      : description_(loadDeviceDescription("vishard10")),
        start_(sessionStart(scene, description_)),
        arm_(description_, start_.angles,
             std::make_unique<ScriptedHand>(
                 std::vector<HandWaypoint>{{0, start_.wanted}, {0.5, start_.wanted + Vector3(0.1, 0.02, 0)}}),
             1) {}

  void start(double period) override { arm_.start(period); }
  DeviceReading read() noexcept override {
    if (ticks_ % 40 > 3) last_ = arm_.read();
    if (ticks_ % 40 > 3) last_.deviceTime = 5'000'000 + 1000 * ticks_ + ticks_ % 3 * 40;
    ++ticks_;
    return last_;
  }
  void write(const DeviceCommand& command) noexcept override { arm_.write(command); }
  void stop() override { arm_.stop(); }

 private:
  DeviceDescription description_;
  SessionStart start_;
  SimulatedDevice arm_;
  DeviceReading last_;
  std::int64_t ticks_ = 4;
};

TEST_F(Resimulation, ByTheDevicesTimeGivesTheSameBits) {
  const SessionLog log(folder_ / "s.h5");
  const HapticScene& scene = log.scenes()[0].scene;
  LossyDevice device(scene);
  std::vector<TickRecord> lossy;
  runFast(device, loadDeviceDescription("vishard10"), 1000, scene, 1000, [&](const TickRecord& record) {
    lossy.push_back(record);
    return true;
  });
  EXPECT_EQ(lossy[999].state, SessionState::running);
  EXPECT_EQ(lossy[79].reading.deviceTime, lossy[76].reading.deviceTime);
  EXPECT_GT(lossy[80].reading.deviceTime, lossy[79].reading.deviceTime + 3000);
  EXPECT_TRUE(verifyWith(lossy).identical());
}

TEST_F(Resimulation, NamesTickAndFieldOfAFlippedBit) {
  std::vector<TickRecord> changed = ticks();
  double& value = changed[1234].desiredPosition.x();
  const double before = value;
  value = std::nextafter(value, 1.0);
  const Verification result = verifyWith(changed);
  ASSERT_FALSE(result.identical());
  EXPECT_EQ(result.first->tick, 1234u);
  EXPECT_EQ(result.first->field, "desired_position_x_m");
  EXPECT_EQ(result.first->logged, std::nextafter(before, 1.0));
  EXPECT_EQ(result.first->resimulated, before);
}

TEST_F(Resimulation, TellsZeroFromMinusZero) {
  std::vector<TickRecord> changed = ticks();
  ASSERT_EQ(changed[0].penetration, 0);
  changed[0].penetration = -changed[0].penetration;
  const Verification result = verifyWith(changed);
  ASSERT_FALSE(result.identical());
  EXPECT_EQ(result.first->field, "penetration_m");
}

TEST_F(Resimulation, NoticesAChangedReading) {
  std::vector<TickRecord> changed = ticks();
  changed[700].reading.encoderCounts[2] += 1;
  const Verification result = verifyWith(changed);
  ASSERT_FALSE(result.identical());
  EXPECT_EQ(result.first->tick, 700u);
  EXPECT_EQ(result.first->field, "joint3_rad");
}

TEST_F(Resimulation, StopsWhereTicksNeverReachedTheLog) {
  std::vector<TickRecord> gap = ticks();
  gap.erase(gap.begin() + 300, gap.begin() + 305);
  const Verification result = verifyWith(gap, 5);
  ASSERT_FALSE(result.identical());
  EXPECT_EQ(result.ticks, 300u);
  EXPECT_EQ(result.first->tick, 305u);
  EXPECT_EQ(result.first->field, "dropped_records");
}

TEST_F(Resimulation, TellsTicksThatAreLostAtTheEnd) {
  std::vector<TickRecord> shorter = ticks();
  shorter.resize(1990);
  EXPECT_TRUE(verifyWith(shorter).identical());
  const Verification result = verifyWith(shorter, 10);
  ASSERT_FALSE(result.identical());
  EXPECT_EQ(result.first->field, "dropped_records");
  EXPECT_EQ(result.first->logged, 2000);
  EXPECT_EQ(result.first->resimulated, 1990);
}

TEST_F(Resimulation, IsNotDisturbedByMissedGridPoints) {
  std::vector<TickRecord> late = ticks();
  for (std::size_t i = 800; i < late.size(); ++i) {
    late[i].tick += 3;
    late[i].missedTicks = 3;
  }
  EXPECT_TRUE(verifyWith(late).identical());
}

TEST_F(Resimulation, ShowsWhatAnotherSceneWouldHaveGiven) {
  const SessionLog log(folder_ / "s.h5");
  std::vector<LoggedScene> stiffer = log.scenes();
  stiffer.at(0).scene.walls.at(0).surface.stiffness *= 2;
  double logged = 0, resimulated = 0;
  resimulate(log, stiffer, [&](const TickRecord& before, const TickRecord& after) {
    EXPECT_EQ(before.tick, after.tick);
    logged = std::max(logged, before.penetration);
    resimulated = std::max(resimulated, after.penetration);
    return true;
  });
  EXPECT_GT(resimulated, 0);
  EXPECT_LT(resimulated, 0.8 * logged);  // the same hand presses as hard into a wall twice as stiff
}

TEST_F(Resimulation, TellsASceneThatIsNotThere) {
  const SessionLog log(folder_ / "s.h5");
  const auto any = [](const TickRecord&, const TickRecord&) { return true; };
  EXPECT_THAT(messageOf([&] { resimulate(log, {}, any); }), HasSubstr("version 0 of the scene"));
}

}  // namespace
}  // namespace haptiv
