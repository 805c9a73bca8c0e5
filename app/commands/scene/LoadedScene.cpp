#include "app/commands/scene/LoadedScene.h"

#include <chrono>
#include <exception>
#include <iostream>

#include "app/commands/NamedFile.h"
#include "app/view/picture/PictureDecoder.h"
#include "scenegraph/Keyword.h"
#include "scenegraph/NumberText.h"
#include "scenegraph/judging/SceneJudge.h"
#include "scenegraph/solid/MakeSolid.h"
#include "scenegraph/solid/SolidModel.h"
#include "scenegraph/writing/SceneWriter.h"

namespace haptiv {
namespace {

/// Says that a long compilation is going on: once after a second, and then every second.
class ProgressLines {
 public:
  explicit ProgressLines(std::string path) : path_(std::move(path)) {}

  void operator()(std::size_t shapes, std::size_t triangles) {
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < std::chrono::seconds(1)) return;
    told_ = now;
    std::cerr << path_ << ": still being prepared: " << shapes << " shapes, " << triangles << " triangles so far\n";
  }

 private:
  std::string path_;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

void note(SceneFile& file, Diagnostic::Severity severity, const std::string& message, const SoNode* node) {
  Diagnostic diagnostic{severity, {}, 0, describe(node), message, node};
  locate(diagnostic, file);
  file.diagnostics.push_back(std::move(diagnostic));
}

void mendSizes(SceneFile& file) {
  for (const NegativeSize& size : negativeSizes(file.root.get())) {
    SbName name;
    size.node->getFieldName(size.field, name);
    const float value = size.field->getValue();
    note(file, Diagnostic::Severity::warning,
         std::string(name.getString()) + " is " + numberText(value) + ": --solid takes it as " + numberText(-value),
         size.node);
    size.field->setValue(-value);
  }
}

/// The file on the disk stays as it is; its text here becomes that of the scene that is felt, for the log.
void makeSolid(SceneFile& file) {
  const std::vector<NodeRef<>> nodes =
      solidNodes(file.root.get(), loadDeviceDescription(DevicePlacement().description));
  if (nodes.empty()) {
    SoNode* root = file.root.get();
    const std::string fault = solidFault(modelBounds(file.root.get()));
    if (!fault.empty())
      return note(file, Diagnostic::Severity::error, "--solid makes nothing of the scene: " + fault, root);
    return note(file, Diagnostic::Severity::warning, "--solid has nothing to add: the scene says itself what is felt",
                root);
  }
  mendSizes(file);
  for (std::size_t i = 0; i < nodes.size(); ++i) file.root->insertChild(nodes[i].get(), static_cast<int>(i));
  file.text = writeSceneText(file.root.get());
}

void judge(LoadedScene& loaded, double rate) {
  const SceneOrigins& origins = loaded.compiled.origins;
  const HapticScene& scene = *loaded.compiled.scene;
  Diagnostics found;
  try {
    loaded.device = loadDeviceDescription(scene.device.description, loaded.file.path);
    found = judgeScene({scene, origins, loaded.device, rate});
  } catch (const std::exception& error) {
    found.push_back({Diagnostic::Severity::error, {}, 0, "HapticDevice", error.what(), origins.device});
  }
  for (Diagnostic& each : found) locate(each, loaded.file);
  loaded.diagnostics.insert(loaded.diagnostics.end(), found.begin(), found.end());
}

}  // namespace

LoadedScene loadScene(const std::string& path, const LoadOptions& options) {
  requireReadable(path);
  LoadedScene loaded;
  loaded.file = readScene(path, pictureDecoder());
  if (loaded.file.root && options.solid) makeSolid(loaded.file);
  loaded.diagnostics = loaded.file.diagnostics;
  if (!loaded.file.root || hasErrors(loaded.diagnostics)) return loaded;
  SceneCompiler compiler;
  compiler.setProgress(ProgressLines(path));
  loaded.compiled = compiler.compile(loaded.file);
  const Diagnostics& found = loaded.compiled.diagnostics;
  loaded.diagnostics.insert(loaded.diagnostics.end(), found.begin(), found.end());
  if (loaded.compiled.scene) judge(loaded, options.rate);
  sortByPlace(loaded.diagnostics);
  return loaded;
}

void tell(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) std::cerr << toText(diagnostic) << "\n";
}

}  // namespace haptiv
