#include "app/session/recording/FlightRecorder.h"

#include <gmock/gmock.h>

#include <functional>

#include "app/session/Resimulation.h"
#include "app/session/log/contents/TickColumns.h"
#include "app/session/log/hdf5/Hdf5Table.h"
#include "app/session/log/reading/LogExport.h"
#include "app/session/log/writing/SessionLogWriter.h"
#include "app/session/recording/SessionRecorder.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using namespace haptiv::testing;

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

TickRecord tickIn(SessionState state, std::uint64_t tick, std::uint32_t sceneVersion = 0) {
  TickRecord record;
  record.tick = tick;
  record.time = static_cast<std::int64_t>(tick) * 1'000'000;
  record.state = state;
  record.sceneVersion = sceneVersion;
  if (state == SessionState::fault) record.faults = kFaultTracking | kFaultSensorStuck;
  return record;
}

TEST(FlightRecorderTest, WritesTheLastTwoSecondsBeforeAFaultAtAnyRate) {
  for (const double rate : {500., 1000., 8000.}) {
    const TemporaryFolder folder;
    SessionHeader header = someHeader();
    header.rate = rate;
    FlightRecorder recorder(header, folder / "made/for/it", "s");
    recorder.addScene(std::make_shared<HapticScene>(wallScene()), "first");
    RandomRecords random(1);
    std::vector<TickRecord> taken;
    const auto ticks = static_cast<std::uint64_t>(3.3 * rate);
    for (std::uint64_t tick = 0; tick <= ticks; ++tick) {
      taken.push_back(random.next(tick, 0));
      taken.back().state = tick < ticks ? SessionState::running : SessionState::fault;
      taken.back().faults = tick < ticks ? kNoFault : kFaultTracking;
      recorder.take(taken.back());
    }
    ASSERT_EQ(recorder.files().size(), 1u);
    EXPECT_THAT(recorder.files()[0].filename().string(),
                AllOf(HasSubstr("s-fault-"), HasSubstr("Z-tracking-error.h5")));
    const SessionLog log(recorder.files()[0]);
    EXPECT_TRUE(log.complete());
    EXPECT_EQ(log.header().fault, "tracking error");
    const std::vector<TickRecord> read = log.ticks(0, taken.size());
    ASSERT_EQ(read.size(), static_cast<std::size_t>(2 * rate));
    for (std::size_t i = 0; i < read.size(); ++i)
      ASSERT_TRUE(sameRecord(read[i], taken[taken.size() - read.size() + i])) << i;
  }
}

TEST(FlightRecorderTest, WritesOneFileAFaultAndKeepsTheScenesThatItsTicksFelt) {
  const TemporaryFolder folder;
  FlightRecorder recorder(someHeader(), folder / "", "s");
  HapticScene scene = wallScene();
  for (scene.version = 0; scene.version < 6; ++scene.version)
    recorder.addScene(std::make_shared<HapticScene>(scene), std::to_string(scene.version));
  for (std::uint64_t tick = 0; tick < 6000; ++tick) {
    const bool fault = tick % 3000 > 2900;
    recorder.take(
        tickIn(fault ? SessionState::fault : SessionState::running, tick, static_cast<std::uint32_t>(tick / 1000)));
  }
  ASSERT_EQ(recorder.files().size(), 2u);
  ASSERT_EQ(filesIn(folder / "").size(), 2u);
  const SessionLog log(recorder.files()[1]);
  EXPECT_EQ(log.header().fault, "tracking error, sensor stuck");
  EXPECT_EQ(log.ticks(0, 1)[0].tick, 5901u - 1999u);
  ASSERT_EQ(log.scenes().size(), 3u);  // 3, 4 and 5
  EXPECT_EQ(log.scenes()[0].text, "3");
}

TEST(FlightRecorderTest, IsExportedButNotResimulatedFromTheMiddleOn) {
  const TemporaryFolder folder;
  FlightRecorder recorder(someHeader(), folder / "", "s");
  recorder.addScene(std::make_shared<HapticScene>(wallScene()), "");
  for (std::uint64_t tick = 0; tick < 3000; ++tick) recorder.take(tickIn(SessionState::running, tick));
  recorder.take(tickIn(SessionState::fault, 3000));
  const SessionLog log(recorder.files().at(0));
  exportCsv(log, folder / "s.csv");
  EXPECT_GT(std::filesystem::file_size(folder / "s.csv"), 100'000u);
  EXPECT_THAT(messageOf([&] { verify(log); }), AllOf(HasSubstr("tracking error"), HasSubstr("starts at tick 1001")));
}

TEST(FlightRecorderTest, IsWrittenByASessionWithAndWithoutALog) {
  constexpr std::uint16_t kStopped = kInputDeadMan | kInputEmergencyStop1;
  for (const bool logged : {true, false}) {
    const TemporaryFolder folder;
    SessionSetup setup = setupFor(wallScene(), {{0, {0, 0, 0}}, {0.5, {0.1, 0, 0}, kStopped}});
    if (logged) setup.log = folder / "s.h5";
    if (!logged) setup.flights = folder / "flights";
    const SessionSummary summary = runFast(setup, 1);
    EXPECT_NE(summary.last.faults & kFaultEmergencyStop, kNoFault);
    ASSERT_EQ(summary.flights.size(), 1u);
    const SessionLog flight(summary.flights[0]);
    EXPECT_THAT(flight.header().fault, HasSubstr("emergency stop"));
    EXPECT_TRUE(verify(flight).identical());  // it starts with the session
    if (!logged) continue;
    const SessionLog log(folder / "s.h5");
    std::vector<std::string> names;
    for (const SessionEvent& event : log.events()) names.push_back(nameOf(event));
    EXPECT_THAT(names, IsSupersetOf({"ready", "running", "emergency stop", "fault"}));
  }
}

TEST(FlightRecorderTest, GoesOnWhereTheLogHasEndedForWantOfSpace) {
  const TemporaryFolder folder;
  std::atomic<std::uint64_t> space = 1u << 30;
  auto writer = std::make_unique<SessionLogWriter>(folder / "s.h5", someHeader(),
                                                   [&space](const std::filesystem::path&) { return space.load(); });
  writer->addScene(wallScene(), "");
  auto flights = std::make_unique<FlightRecorder>(someHeader(), folder / "flights", "s");
  flights->addScene(std::make_shared<HapticScene>(wallScene()), "");
  RecordRing<TickRecord> ring(8192);
  SessionRecorder recorder(ring, std::move(writer), std::move(flights));
  space = 0;
  for (std::uint64_t tick = 0; tick < 600; ++tick) ring.push(tickIn(SessionState::running, tick));
  while (recorder.trouble().empty()) std::this_thread::yield();
  ring.push(tickIn(SessionState::fault, 600));
  const SessionSummary summary = recorder.stop();
  ASSERT_EQ(summary.flights.size(), 1u);
  EXPECT_EQ(SessionLog(summary.flights[0]).tickCount(), 601u);
}

TEST(SessionEventsTest, TellStatesFaultsAndTripsInOrder) {
  EventFinder finder;
  std::vector<std::string> names;
  const auto take = [&](SessionState state, std::uint32_t faults, std::uint32_t trips) {
    TickRecord record = tickIn(SessionState::running, names.size());
    record.state = state;
    record.faults = faults;
    record.reading.trips = trips;
    finder.take(record, [&](const SessionEvent& event) {
      names.push_back(std::string(nameOf(event.kind)) + " " + nameOf(event));
    });
  };
  take(SessionState::ready, 0, 0);
  take(SessionState::ready, 0, 0);
  take(SessionState::running, 0, 0);
  take(SessionState::fault, kFaultTripWatchdog | kFaultTracking, kTripWatchdog);
  take(SessionState::fault, kFaultTripWatchdog | kFaultTracking, kTripWatchdog);
  take(SessionState::ready, 0, 0);
  EXPECT_THAT(names, ElementsAre("state ready", "state running", "trip watchdog", "fault tracking error",
                                 "fault device trip: watchdog", "state fault", "state ready"));
}

/// After format 1.
bool cameLater(const std::string& column) {
  for (const char* name : {"device_time_us", "inputs", "trips", "clamps", "session_state", "drive_mode"})
    if (column == name) return true;
  return column.ends_with("N_m");
}

/// Writes a group of ticks anew, without some columns.
void dropColumns(const hdf5::Handle& file, const std::filesystem::path& path, const TickGroup& group,
                 const std::function<bool(const std::string&)>& dropped) {
  const std::string name = "/servo/" + group.name;
  std::vector<std::string> kept;
  std::vector<std::byte> rows, less;
  std::uint64_t count = 0;
  {
    const hdf5::Table table = hdf5::Table::open(file, path, name, group.cell, group.columns.size());
    count = table.rows();
    rows.resize(count * group.rowSize());
    table.read(0, count, rows.data());
  }
  const std::size_t cell = hdf5::sizeOf(group.cell);
  for (std::size_t i = 0; i < rows.size() / cell; ++i) {
    if (dropped(group.columns[i % group.columns.size()].name)) continue;
    less.insert(less.end(), rows.begin() + static_cast<std::ptrdiff_t>(i * cell),
                rows.begin() + static_cast<std::ptrdiff_t>((i + 1) * cell));
  }
  for (const TickColumn& column : group.columns)
    if (!dropped(column.name)) kept.push_back(column.name);
  H5Ldelete(file.id(), name.c_str(), H5P_DEFAULT);
  hdf5::Table::create(file, path, name, group.cell, kept.size(), 500).append(less.data(), count);
  hdf5::Attributes(file, path, name).write("columns", kept);
}

void setFormat(const hdf5::Handle& file, std::uint64_t format) {
  const hid_t version = H5Aopen(file.id(), "format_version", H5P_DEFAULT);
  H5Awrite(version, H5T_NATIVE_UINT64, &format);
  H5Aclose(version);
}

/// Turns a log into one of format 1: without the columns, the tables and the attribute that came later.
void makeFirstFormat(const std::filesystem::path& path) {
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  ASSERT_TRUE(file);
  setFormat(file, 1);
  H5Adelete(file.id(), "fault");
  H5Ldelete(file.id(), "/events", H5P_DEFAULT);
  for (const TickGroup& group : tickGroups()) {
    if (group.name != "passivity") dropColumns(file, path, group, cameLater);
  }
  H5Ldelete(file.id(), "/servo/passivity", H5P_DEFAULT);
}

TEST(SessionLogOfFormatOne, OpensWithDefaultsForWhatCameLaterAndIsNotResimulated) {
  const TemporaryFolder folder;
  RandomRecords random(7);
  std::vector<TickRecord> written = random.some(0, 600);
  {
    SessionLogWriter writer(folder / "s.h5", someHeader());
    writer.addScene(wallScene(), "first");
    writer.append(written);
    writer.close(0);
  }
  makeFirstFormat(folder / "s.h5");
  const SessionLog log(folder / "s.h5");
  EXPECT_TRUE(log.complete());
  EXPECT_EQ(log.formatVersion(), 1u);
  EXPECT_TRUE(log.events().empty());
  EXPECT_EQ(log.header().fault, "");
  const std::vector<TickRecord> read = log.ticks(0, 600);
  ASSERT_EQ(read.size(), 600u);
  for (std::size_t i = 0; i < read.size(); ++i) {
    TickRecord& expected = written[i];
    expected.passivityEnergy = expected.passivityDamping = 0;
    expected.reading.deviceTime = 0;
    expected.reading.inputs = kInputDeadMan;
    expected.reading.trips = expected.clamps = 0;
    expected.handTorque.setZero();
    expected.command.jointTorques.setZero();
    expected.state = expected.command.enabled ? SessionState::running : SessionState::fault;
    ASSERT_TRUE(sameRecord(read[i], expected)) << i;
  }
  EXPECT_THAT(messageOf([&] { verify(log); }), HasSubstr("format 1"));
}

void changeLog(const std::filesystem::path& path, const std::function<void(const hdf5::Handle&)>& change) {
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  ASSERT_TRUE(file);
  change(file);
}

TEST(SessionLogOfFormatTwo, HasNoDeviceTimeAndGivesTheSameBits) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "s.h5";
  SessionSetup setup = setupFor(wallScene(), {{0, Vector3::Zero()}, {0.5, Vector3(0.1, 0.02, 0)}});
  setup.log = path;
  runFast(setup, 1);
  changeLog(path, [&](const hdf5::Handle& file) {
    for (const TickGroup& group : tickGroups())
      if (group.name == "time")
        dropColumns(file, path, group, [](const std::string& name) { return name == "device_time_us"; });
  });
  EXPECT_THAT(messageOf([&] { SessionLog log(path); }), HasSubstr("other columns"));
  changeLog(path, [](const hdf5::Handle& file) { setFormat(file, 2); });
  const SessionLog log(path);
  EXPECT_EQ(log.formatVersion(), 2u);
  EXPECT_EQ(log.ticks(999, 1).at(0).reading.deviceTime, 0);
  EXPECT_TRUE(verify(log).identical());
}

}  // namespace
}  // namespace haptiv
