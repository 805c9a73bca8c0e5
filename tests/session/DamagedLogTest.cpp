#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "app/session/log/reading/LogProbe.h"
#include "app/session/log/writing/SessionLogWriter.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace haptiv::testing;

/// A short log and its bytes.
class DamagedLog : public ::testing::Test {
 protected:
  DamagedLog() {
    RandomRecords random(11);
    written_ = random.some(0, 60);
    SessionHeader header = someHeader();
    header.rate = 40;  // 20 rows a chunk
    SessionLogWriter writer(folder_ / "s.h5", header);
    writer.addScene(wallScene(), "first");
    writer.append(written_);
    writer.close(0);
    std::ifstream stream(folder_ / "s.h5", std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
  }

  /// Writes the bytes, reads them as a log. Returns whether it was read as complete; an error must be a clear one, and
  /// what is read must be what was written.
  bool reads(const std::string& bytes) {
    const std::filesystem::path path = folder_ / "damaged.h5";
    std::ofstream(path, std::ios::binary) << bytes;
    try {
      const SessionLog log(path);
      const std::vector<TickRecord> ticks = log.ticks(0, log.tickCount());
      EXPECT_LE(ticks.size(), written_.size());
      for (std::size_t i = 0; i < ticks.size() && i < written_.size(); ++i)
        EXPECT_TRUE(sameRecord(ticks[i], written_[i])) << "tick " << i << " is wrong, and nobody said so";
      return log.complete();
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("damaged.h5"));
      return false;
    }
  }

  TemporaryFolder folder_;
  std::vector<TickRecord> written_;
  std::string bytes_;
};

TEST_F(DamagedLog, IsReadWhenItIsNotDamaged) {
  EXPECT_TRUE(reads(bytes_));
}

TEST_F(DamagedLog, CutOffAnywhereIsAnErrorOrIncomplete) {
  constexpr std::size_t kLengths = 80;
  for (std::size_t i = 0; i < kLengths; ++i) {
    const std::size_t length = bytes_.size() * i / kLengths;
    EXPECT_FALSE(reads(bytes_.substr(0, length))) << "cut off after " << length << " of " << bytes_.size() << " bytes";
  }
}

TEST_F(DamagedLog, FlippedBytesAreNeverTakenForTicks) {
  std::mt19937_64 random(12);
  int noticed = 0;
  for (int i = 0; i < 200; ++i) {
    std::string bytes = bytes_;
    const std::size_t at = random() % bytes.size();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
    SCOPED_TRACE("byte " + std::to_string(at));
    noticed += reads(bytes) ? 0 : 1;
  }
  EXPECT_GT(noticed, 0);  // others hit bytes that hold nothing
}

TEST_F(DamagedLog, NoiseBehindTheSignatureIsAnError) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 20; ++i) {
    std::string bytes = bytes_;
    for (std::size_t at = 8; at < bytes.size(); ++at) bytes[at] = static_cast<char>(random());
    EXPECT_FALSE(reads(bytes));
  }
}

TEST(LogProbe, PassesOnWhatTheReaderSays) {
  EXPECT_NO_THROW(probeInChild(
      "s.h5", [] {}, std::chrono::seconds(5)));
  const auto trouble = [] { throw std::runtime_error("s.h5: no good"); };
  EXPECT_EQ(messageOf([&] { probeInChild("s.h5", trouble, std::chrono::seconds(5)); }), "s.h5: no good");
}

TEST(LogProbe, OutlivesAReaderThatHangs) {
  const auto hang = [] {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  };
  EXPECT_THAT(messageOf([&] { probeInChild("s.h5", hang, std::chrono::seconds(1)); }),
              AllOf(HasSubstr("s.h5"), HasSubstr("did not end")));
}

TEST(LogProbe, OutlivesAReaderThatCrashes) {
  const auto crash = [] { std::raise(SIGKILL); };
  EXPECT_THAT(messageOf([&] { probeInChild("s.h5", crash, std::chrono::seconds(5)); }),
              AllOf(HasSubstr("s.h5"), HasSubstr("crashed")));
}

}  // namespace
}  // namespace haptiv
