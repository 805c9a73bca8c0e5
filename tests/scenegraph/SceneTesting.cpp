#include "tests/scenegraph/SceneTesting.h"

#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace haptiv::testing {

namespace fs = std::filesystem;

std::string contentsOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void put(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

int trianglesOf(const SceneFile& scene) {
  SoGetPrimitiveCountAction count;
  count.apply(scene.root.get());
  return count.getTriangleCount();
}

std::vector<fs::path> scenesIn(const fs::path& folder) {
  std::vector<fs::path> scenes;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".iv") scenes.push_back(entry.path());
  }
  std::ranges::sort(scenes);
  return scenes;
}

std::string nameOfFile(const ::testing::TestParamInfo<fs::path>& file) {
  std::string name = file.param.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
}

std::string textOf(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += toText(diagnostic) + "\n";
  return text;
}

SceneFile read(const std::string& body) {
  SceneFile scene = readSceneText(kHeader + body, "test.iv");
  EXPECT_TRUE(scene.root) << textOf(scene.diagnostics);
  return scene;
}

CompiledScene compile(const std::string& body) {
  const SceneFile scene = read("HapticTool { home 1000 0 0 } " + body);  // far from every wall
  if (!scene.root) return {};
  return SceneCompiler().compile(scene);
}

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "haptiv-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no scratch folder can be made");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::permissions(path_, fs::perms::owner_all, ignored);
  fs::remove_all(path_, ignored);
}

}  // namespace haptiv::testing
