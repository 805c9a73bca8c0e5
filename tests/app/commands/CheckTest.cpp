#include <gmock/gmock.h>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

/// Checks a scene both ways; it must be refused with 1, name the line, and say the same to people and programs.
Json expectErrors(const std::string& text, int line) {
  const TestFolder folder;
  const std::string scene = folder.write("scene.iv", text);
  const Ended forPrograms = runHaptiv({"check", scene, "--json"});
  EXPECT_EQ(forPrograms.code, 1) << text;
  EXPECT_EQ(forPrograms.err, "");
  const Json report = forPrograms.json();
  EXPECT_FALSE(report.is_discarded()) << forPrograms.out;
  EXPECT_FALSE(report["errors"].empty());
  if (line > 0) {
    EXPECT_EQ(report["errors"].at(0)["line"], line);
  }

  const Ended forPeople = runHaptiv({"check", scene});
  EXPECT_EQ(forPeople.code, 1);
  EXPECT_THAT(forPeople.err, HasSubstr(scene + (line > 0 ? ":" + std::to_string(line) : "") + ": error: "));
  EXPECT_THAT(forPeople.err, HasSubstr(report["errors"].at(0)["message"].get<std::string>()));

  const Ended run = runHaptiv({"run", scene, "--fast", "--json"});
  EXPECT_EQ(run.code, 1) << "a scene that is not good is not run";
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr(scene));
  return report;
}

}  // namespace

TEST(Check, CountsWhatIsFelt) {
  const TestFolder folder;
  const std::string zones = R"(
  Separator { HapticViscousZone { } Sphere { radius 0.1 } }
  Separator { HapticSpringZone { } Cube { width 0.1 height 0.1 depth 0.1 } }
  Separator { HapticNone { } Cube { } })";
  const Ended ended = runHaptiv({"check", folder.write("scene.iv", wallScene("", zones)), "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
  const Json report = ended.json();
  EXPECT_EQ(report["walls"], 1);
  EXPECT_EQ(report["zones"], 2);
  EXPECT_GE(report["triangles"].get<int>(), 3 * 12);  // three cubes, and the sphere as finely as Coin likes
  EXPECT_TRUE(report["errors"].is_array());
  EXPECT_TRUE(report["errors"].empty()) << report;
  EXPECT_TRUE(report["warnings"].is_array());
}

TEST(Check, NamesTheLineOfASyntaxError) {
  expectErrors("#Inventor V2.1 ascii\nSeparator {\n  Cube { width }\n}\n", 3);
}

TEST(Check, NamesTheLineOfANegativeStiffness) {
  const Json report = expectErrors(wallScene("stiffness -5"), 6);
  EXPECT_THAT(report["errors"][0]["node"].get<std::string>(), HasSubstr("HapticSurface"));
}

TEST(Check, MissesTheTool) {
  const Json report = expectErrors("#Inventor V2.1 ascii\nSeparator {\n  Cube { }\n}\n", 2);
  EXPECT_THAT(report["errors"].dump(), HasSubstr("HapticTool"));
}

TEST(Check, NamesADeviceThatThereIsNot) {
  const Json report = expectErrors(
      "#Inventor V2.1 ascii\nSeparator {\n  HapticDevice { description \"hammer\" }\n  HapticTool { home 0.3 0 0 "
      "}\n}\n",
      3);
  EXPECT_THAT(report["errors"].dump(), HasSubstr("vishard10"));
}

TEST(Check, FindsAHomeOutOfTheArmsReach) {
  expectErrors("#Inventor V2.1 ascii\nSeparator {\n  HapticTool { home 5 0 0 }\n}\n", 3);
}

TEST(Check, RefusesWhatIsNoScene) {
  expectErrors("this is a letter to a friend\n", 1);
  expectErrors("", 1);
  const Ended ended = runHaptiv({"check", "/dev"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("folder"));
}

TEST(Check, TakesEveryShippedScene) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(HAPTIV_SOURCE_DIR) + "/scenes")) {
    if (entry.path().extension() != ".iv") continue;
    const Ended ended = runHaptiv({"check", entry.path(), "--json"});
    EXPECT_EQ(ended.code, 0) << entry.path() << ended.out;
    EXPECT_GE(ended.json()["walls"].get<int>() + ended.json()["zones"].get<int>(), 1) << entry.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 2);
}

}  // namespace haptiv
