#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "app/session/log/writing/SessionLogWriter.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace haptiv::testing;

constexpr std::size_t kFlushRows = 500;  // half a second at the header's 1 kHz

void expectSame(const std::vector<TickRecord>& read, const std::vector<TickRecord>& written) {
  ASSERT_LE(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) ASSERT_TRUE(sameRecord(read[i], written[i])) << "tick " << i;
}

TEST(SessionLog, GivesBackRandomRecordsBitForBit) {
  const TemporaryFolder folder;
  RandomRecords random(1);
  const std::vector<TickRecord> written = random.some(0, 1777);
  {
    SessionLogWriter writer(folder / "s.h5", someHeader());
    writer.addScene(wallScene(), "first");
    const std::span<const TickRecord> all(written);
    writer.append(all.first(3));
    writer.flush();
    writer.append(all.subspan(3, 1300));
    writer.append(all.subspan(1303));
    writer.close(0);
  }
  const SessionLog log(folder / "s.h5");
  EXPECT_TRUE(log.complete());
  EXPECT_EQ(log.dropped(), 0u);
  ASSERT_EQ(log.tickCount(), written.size());
  expectSame(log.ticks(0, 5000), written);
  const std::vector<TickRecord> middle = log.ticks(498, 5);
  ASSERT_EQ(middle.size(), 5u);
  EXPECT_TRUE(sameRecord(middle[0], written[498]));
  EXPECT_TRUE(log.ticks(1777, 1).empty());
}

TEST(SessionLog, GivesBackItsHeader) {
  const TemporaryFolder folder;
  const SessionHeader header = someHeader();
  SessionLogWriter(folder / "s.h5", header).close(17);
  const SessionLog log(folder / "s.h5");
  EXPECT_EQ(log.header().sceneName, header.sceneName);
  EXPECT_EQ(log.header().sceneText, header.sceneText);
  EXPECT_EQ(log.header().deviceText, header.deviceText);
  EXPECT_EQ(log.header().softwareVersion, header.softwareVersion);
  EXPECT_EQ(log.header().gitHash, header.gitHash);
  EXPECT_EQ(log.header().startUtc, header.startUtc);
  EXPECT_EQ(log.header().scheduling, header.scheduling);
  EXPECT_EQ(log.header().seed, header.seed);
  EXPECT_EQ(log.header().rate, header.rate);
  EXPECT_EQ(log.dropped(), 17u);
  EXPECT_EQ(log.tickCount(), 0u);
}

TEST(SessionLog, GivesBackEveryVersionOfTheScene) {
  const TemporaryFolder folder;
  {
    SessionLogWriter writer(folder / "s.h5", someHeader());
    HapticScene scene = wallScene();
    writer.addScene(scene, "first");
    scene.version = 4;
    scene.walls[0].surface.stiffness = 1234.5;
    writer.addScene(scene, "");
    EXPECT_THAT(messageOf([&] { writer.addScene(scene, "again"); }),
                HasSubstr("version 4 comes after one of version 4"));
    writer.close(0);
  }
  const SessionLog log(folder / "s.h5");
  ASSERT_EQ(log.scenes().size(), 2u);
  EXPECT_EQ(log.scenes()[0].text, "first");
  EXPECT_EQ(log.scenes()[1].text, "");
  EXPECT_EQ(log.scenes()[1].scene.version, 4u);
  EXPECT_EQ(log.scenes()[1].scene.walls.at(0).surface.stiffness, 1234.5);
}

TEST(SessionLog, SurvivesTheKillOfItsWriter) {
  const TemporaryFolder folder;
  constexpr std::size_t kStep = 130;
  constexpr int kSteps = 37;
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    RandomRecords random(2);
    SessionLogWriter writer(folder / "s.h5", someHeader());
    writer.addScene(wallScene(), "first");
    for (std::uint64_t first = 0;; first += kStep) {
      writer.append(random.some(first, kStep));
      if (write(ends[1], "x", 1) != 1) _exit(1);
    }
  }
  char step = 0;
  for (int i = 0; i < kSteps; ++i) ASSERT_EQ(read(ends[0], &step, 1), 1);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ends[0]);
  close(ends[1]);

  const SessionLog log(folder / "s.h5");
  EXPECT_FALSE(log.complete());
  EXPECT_GE(log.tickCount(), kSteps * kStep / kFlushRows * kFlushRows);  // no more than the last flush is lost
  RandomRecords random(2);
  std::vector<TickRecord> written;
  while (written.size() < log.tickCount())
    for (const TickRecord& record : random.some(written.size(), kStep)) written.push_back(record);
  expectSame(log.ticks(0, log.tickCount()), written);
}

TEST(SessionLog, IsReadableWhileItIsWritten) {
  const TemporaryFolder folder;
  RandomRecords random(3);
  const std::vector<TickRecord> written = random.some(0, 700);
  SessionLogWriter writer(folder / "s.h5", someHeader());
  writer.addScene(wallScene(), "first");
  writer.append(written);
  const pid_t reader = fork();  // another program, as HDF5 shares what it knows of a file within a process
  if (reader == 0) {
    try {
      const SessionLog log(folder / "s.h5");
      _exit(!log.complete() && log.tickCount() == kFlushRows ? 0 : 1);
    } catch (const std::exception&) {
      _exit(2);
    }
  }
  int status = 0;
  waitpid(reader, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(SessionLog, EndsEarlyOnADiskThatIsNearlyFull) {
  const TemporaryFolder folder;
  RandomRecords random(4);
  const std::vector<TickRecord> written = random.some(0, 3 * kFlushRows);
  std::uint64_t space = 1u << 30;
  SessionLogWriter writer(folder / "s.h5", someHeader(), [&space](const std::filesystem::path&) { return space; });
  writer.addScene(wallScene(), "first");
  writer.append(std::span(written).first(2 * kFlushRows));
  space = 1u << 20;
  EXPECT_THAT(messageOf([&] { writer.append(std::span(written).last(kFlushRows)); }),
              AllOf(HasSubstr("s.h5"), HasSubstr("nearly full"), HasSubstr("stays readable")));
  EXPECT_THAT(messageOf([&] { writer.append(written); }), HasSubstr("has been ended"));

  const SessionLog log(folder / "s.h5");
  EXPECT_FALSE(log.complete());
  ASSERT_EQ(log.tickCount(), 2 * kFlushRows);
  expectSame(log.ticks(0, 2 * kFlushRows), written);
}

TEST(SessionLog, RefusesToStartOnAFullDisk) {
  const TemporaryFolder folder;
  const auto none = [](const std::filesystem::path&) { return std::uint64_t{0}; };
  EXPECT_THAT(messageOf([&] { SessionLogWriter(folder / "s.h5", someHeader(), none); }), HasSubstr("nearly full"));
  EXPECT_FALSE(std::filesystem::exists(folder / "s.h5"));
}

// The kernel refuses to let the file grow, as it does on a full disk that nobody saw coming.
TEST(SessionLog, StaysReadableWhenAWriteFails) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1u << 20, 1u << 20};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      RandomRecords random(5);
      SessionLogWriter writer(folder / "s.h5", someHeader());
      writer.addScene(wallScene(), "first");
      for (std::uint64_t first = 0; first < 100'000; first += kFlushRows) writer.append(random.some(first, kFlushRows));
    } catch (const std::runtime_error& error) {
      if (std::string(error.what()).find("free space") == std::string::npos) _exit(2);
      std::exit(SessionLog(folder / "s.h5").complete() ? 3 : 0);  // and HDF5's own clean-up does no harm
    }
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 0);

  const SessionLog log(folder / "s.h5");
  EXPECT_FALSE(log.complete());
  EXPECT_GE(log.tickCount(), kFlushRows);
  RandomRecords random(5);
  std::vector<TickRecord> written;
  while (written.size() < log.tickCount())
    for (const TickRecord& record : random.some(written.size(), kFlushRows)) written.push_back(record);
  expectSame(log.ticks(0, log.tickCount() / kFlushRows * kFlushRows), written);
}

TEST(SessionLog, GoesByItsShortestGroup) {
  const TemporaryFolder folder;
  RandomRecords random(6);
  {
    SessionLogWriter writer(folder / "s.h5", someHeader());
    writer.addScene(wallScene(), "first");
    writer.append(random.some(0, 900));
    writer.close(0);
  }
  const hid_t file = H5Fopen((folder / "s.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t group = H5Dopen2(file, "/servo/tool", H5P_DEFAULT);
  const hsize_t extent[] = {850, 18};
  ASSERT_GE(H5Dset_extent(group, extent), 0);
  H5Dclose(group);
  H5Fclose(file);
  const SessionLog log(folder / "s.h5");
  EXPECT_EQ(log.tickCount(), 850u);
  EXPECT_FALSE(log.complete());
}

}  // namespace
}  // namespace haptiv
