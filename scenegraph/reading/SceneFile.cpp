#include "scenegraph/reading/SceneFile.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInteraction.h>

#include <exception>
#include <utility>

#include "scenegraph/nodes/HapticNodes.h"
#include "scenegraph/nurbs/TrimmableNurbs.h"
#include "scenegraph/reading/SceneReader.h"
#include "scenegraph/reading/coin/FinestLevels.h"
#include "scenegraph/reading/coin/NurbsContext.h"
#include "scenegraph/reading/coin/SceneCameras.h"
#include "scenegraph/reading/files/SceneBytes.h"
#include "scenegraph/reading/files/SilentNodes.h"
#include "scenegraph/reading/graph/NodeLines.h"
#include "scenegraph/reading/text/SceneScan.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;

SceneFile refused(const std::string& name, std::string why) {
  SceneFile scene;
  scene.path = name;
  scene.diagnostics.push_back({Diagnostic::Severity::error, name, 0, {}, std::move(why), nullptr});
  return scene;
}

SceneFile readContents(SceneBytes contents, const std::string& name, const DecodePicture& decode = {}) {
  if (!contents.fault.empty()) return refused(name, std::move(contents.fault));
  return SceneReader(fs::path(name).parent_path(), decode).read(std::move(contents.bytes), name);
}

/// What else may go wrong is out of memory, mostly.
template <typename Read>
SceneFile orRefused(const std::string& name, const Read& read) {
  try {
    return read();
  } catch (const std::exception& error) {
    return refused(name, std::string("cannot be read: ") + error.what());
  }
}

}  // namespace

void locate(Diagnostic& diagnostic, const SceneFile& scene) {
  const auto file = scene.fileOf.find(diagnostic.source);
  diagnostic.file = file == scene.fileOf.end() ? scene.path : file->second;
  const auto line = scene.lineOf.find(diagnostic.source);
  if (line != scene.lineOf.end()) diagnostic.line = line->second;
}

void moveTo(const fs::path& path, const std::string& text, SceneFile& scene) {
  const std::string before = std::exchange(scene.path, path.string());
  auto lines = findLines(scanSceneText(text, scene.path), scene.root.get(), text.starts_with("#VRML V2"));
  for (const auto& [node, file] : scene.fileOf) {
    if (const auto line = scene.lineOf.find(node); line != scene.lineOf.end()) lines[node] = line->second;
  }
  scene.lineOf = std::move(lines);
  for (Diagnostic& diagnostic : scene.diagnostics) {
    if (diagnostic.file != before) continue;
    diagnostic.line = 0;
    locate(diagnostic, scene);
  }
}

void initSceneGraph() {
  forbidNodeLibraries();
  SoDB::init();
  SoInteraction::init();
  SoDB::enableRealTimeSensor(FALSE);  // what moved by itself would be seen where it is not felt
  silenceFileNodes();
  initHapticNodes();
  quietSceneCameras();
  showFinestLevels();
  cutNurbsWithoutDisplay();
  makeNurbsTrimmable();
}

SceneFile readScene(const fs::path& path, const DecodePicture& decode) {
  const std::string name = path.string();
  return orRefused(name, [&] { return readContents(readSceneBytes(path), name, decode); });
}

SceneFile readSceneText(std::string_view text, const std::string& name) {
  return orRefused(name, [&] { return readContents(unpackScene(std::string(text)), name); });
}

void judgeAgain(SceneFile& scene) {
  scene.diagnostics.clear();
  SceneReader::judge(scene);
}

}  // namespace haptiv
