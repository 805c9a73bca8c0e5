/// `haptiv device calibrate` and `haptiv device home`, with a simulated arm that is not quite as described.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

const std::string kBuiltIn = HAPTIV_SOURCE_DIR "/device/descriptions/vishard10.toml";

}  // namespace

TEST(Calibrate, FindsTheBiasAndWritesItIntoTheDescription) {
  const TestFolder folder;
  const std::string out = folder / "mine.toml";
  const Ended ended = runHaptiv({"device", "calibrate", kBuiltIn, "--out", out, "--seed", "3", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = ended.json();
  EXPECT_EQ(report["bias_N"].size(), 3u);
  EXPECT_GT(std::abs(report["bias_N"][0].get<double>()), 0.1);
  const std::string before = readFile(kBuiltIn), after = readFile(out);
  EXPECT_THAT(after, HasSubstr("[sensor]                 # six axes, at the handle; 16-bit counts\nbias = ["));
  EXPECT_EQ(after.size() - before.size(), after.find('\n', after.find("bias = [")) + 1 - after.find("bias = ["));
  EXPECT_EQ(runHaptiv({"kinematics", "--description", out, "--q", "0,0,0,0,0,0,0,0,0,0"}).code, 0) << "it loads";
}

TEST(Calibrate, FindsTheMatrixFromKnownLoads) {
  const TestFolder folder;
  const std::string out = folder / "mine.toml";
  const Ended ended = runHaptiv({"device", "calibrate", "--loads", "standard", "--out", out, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = ended.json();
  EXPECT_EQ(report["loads"], 12);
  EXPECT_LT(report["condition"].get<double>(), 3);
  EXPECT_EQ(report["matrix"].size(), 6u);
  EXPECT_LT(report["residual_N"][0].get<double>(), 0.02);
  EXPECT_THAT(readFile(out), HasSubstr("matrix = [\n  ["));
  // The same arm by what was found: what was wrong is gone but for noise.
  const Ended again = runHaptiv({"device", "calibrate", out, "--json"});
  ASSERT_EQ(again.code, 0) << again.err;
}

TEST(Calibrate, RefusesLoadsThatLeaveAnAxisOpen) {
  const TestFolder folder;
  std::string loads = "fx,fy,fz,tx,ty,tz\n";
  for (int i = 0; i < 8; ++i) loads += std::to_string(1 + i) + ",0,0,0,0,0\n";
  const std::string out = folder / "mine.toml";
  const Ended ended =
      runHaptiv({"device", "calibrate", "--loads", folder.write("loads.csv", loads), "--out", out, "--seconds", "0.5"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("tell the axes badly apart"));
  EXPECT_EQ(readFile(out), "") << "nothing is written";
}

TEST(Calibrate, NamesALoadsFileThatIsBadAndADeviceThatIsNone) {
  const TestFolder folder;
  const Ended bad = runHaptiv({"device", "calibrate", "--loads", folder.write("loads.csv", "fx\n")});
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err, HasSubstr("loads.csv:1: "));
  EXPECT_EQ(runHaptiv({"device", "calibrate", "--device", "toaster"}).code, 2);
  EXPECT_EQ(runHaptiv({"device", "calibrate", "--seconds", "0"}).code, 2);
  EXPECT_EQ(runHaptiv({"device", "calibrate", folder / "missing.toml"}).code, 3);
}

TEST(Home, FindsTheZerosAndWritesThemIntoTheDescription) {
  const TestFolder folder;
  const std::string out = folder / "mine.toml";
  const Ended ended = runHaptiv({"device", "home", "--out", out, "--seed", "4", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = ended.json();
  EXPECT_EQ(report["zero_counts"].size(), 10u);
  EXPECT_TRUE(report["homed"].get<bool>());
  double most = 0;
  for (const Json& change : report["change_rad"]) most = std::max(most, std::abs(change.get<double>()));
  EXPECT_GT(most, 0.01);
  EXPECT_LT(most, 0.1);
  EXPECT_THAT(readFile(out), HasSubstr("[encoders]\nzero = ["));
}

TEST(Home, RefusesAPoseThatCannotBeTheReferencePose) {
  const TestFolder folder;
  const std::string arm =
      folder.write("arm.toml", readFile(kBuiltIn) + "\n[encoders]\nzero = [0, 0, 0, 0, 0, 0, 0, 0, 0, 99999]\n");
  const std::string out = folder / "mine.toml";
  // The simulated arm is built by its description; one whose zero is lost is another.
  const std::string lost =
      folder.write("lost.toml", readFile(kBuiltIn) + "\n[encoders]\nreference = [0, 0, 0, 0, 0, 0, 0, 0, 0, 1e5]\n");
  EXPECT_EQ(runHaptiv({"device", "home", lost, "--out", out}).code, 3) << "beyond the counters";
  EXPECT_EQ(runHaptiv({"device", "home", arm, "--out", out}).code, 0);
  EXPECT_EQ(runHaptiv({"device", "home", "--out", folder / "no/such/folder.toml"}).code, 3);
}

TEST(Home, WithoutAFileTellsTheDeviceWhatTheDescriptionSays) {
  const Ended ended = runHaptiv({"device", "home", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(ended.json()["homed"].get<bool>());
  EXPECT_EQ(ended.json()["zero_counts"][0], 0);
}

}  // namespace haptiv
