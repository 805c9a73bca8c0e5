#include <gmock/gmock.h>

#include <sstream>

#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;

/// What the file itself says that it is refused for, in comments: "# expect: LINE: NODE: PART OF THE MESSAGE".
std::vector<std::string> expectationsOf(const std::string& text) {
  std::vector<std::string> expectations;
  static const std::string kMark = "# expect: ";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (const auto at = line.find(kMark); at != std::string::npos)
      expectations.push_back(line.substr(at + kMark.size()));
  }
  return expectations;
}

class BadScene : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(BadScene, IsRefusedWithTheDiagnosticThatItNames) {
  const SceneFile scene = readScene(GetParam());
  Diagnostics diagnostics = scene.diagnostics;
  if (scene.root) {
    const CompiledScene compiled = SceneCompiler().compile(scene);
    diagnostics.insert(diagnostics.end(), compiled.diagnostics.begin(), compiled.diagnostics.end());
    EXPECT_FALSE(compiled.scene);
  }
  EXPECT_TRUE(hasErrors(diagnostics));
  std::string text;
  for (const Diagnostic& one : diagnostics)
    text += std::to_string(one.line) + ": " + one.node + ": " + one.message + "\n";
  const auto expectations = expectationsOf(scene.text);
  EXPECT_FALSE(expectations.empty()) << "the file has no \"# expect: \" line; it gives\n" << text;
  for (const std::string& expected : expectations) EXPECT_THAT(text, HasSubstr(expected));
}

INSTANTIATE_TEST_SUITE_P(Data, BadScene,
                         ::testing::ValuesIn(testing::scenesIn(testing::sourceDir() / "tests/data/scenes")),
                         testing::nameOfFile);

}  // namespace
}  // namespace haptiv
