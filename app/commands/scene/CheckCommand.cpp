#include "app/commands/scene/CheckCommand.h"

#include <iostream>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/Report.h"
#include "app/commands/scene/LoadedScene.h"
#include "app/commands/scene/WallProperties.h"
#include "scenegraph/GraphWalk.h"

namespace haptiv {
namespace {

struct CheckOptions {
  std::string scene;
  double rate = 1000;  // [Hz]
  bool json = false;
};

int checkScene(const CheckOptions& options) {
  initSceneGraph();
  const LoadedScene loaded = loadScene(options.scene, {false, options.rate});
  const auto count = [&loaded](auto member) -> Report::Value {
    if (!loaded.compiled.scene) return nullptr;
    return std::uint64_t{((*loaded.compiled.scene).*member).size()};
  };
  SoNode* root = loaded.file.root.get();
  const Report::Value triangles = root ? Report::Value(std::uint64_t{drawnTriangles(root)}) : nullptr;
  Report report;
  report.add("walls", count(&HapticScene::walls));
  report.add("zones", count(&HapticScene::zones));
  report.add("triangles", triangles);
  report.add("errors", listOf(loaded.diagnostics, Diagnostic::Severity::error));
  report.add("warnings", listOf(loaded.diagnostics, Diagnostic::Severity::warning));
  const bool isValid = loaded.compiled.scene != nullptr;
  if (options.json && isValid) report.add("wall_properties", wallProperties(loaded, options.rate));
  if (!options.json) tell(loaded.diagnostics);
  report.print(options.json);
  if (!options.json && isValid) std::cout << wallTable(loaded, options.rate) << std::flush;
  return hasErrors(loaded.diagnostics) ? kNotSo : kGood;
}

}  // namespace

void addCheckCommand(const Command& program) {
  const auto options = std::make_shared<CheckOptions>();
  const Command check = program.add("check", "Load and judge a scene", [options] { return checkScene(*options); });
  check.path("SCENE", options->scene, "Scene to be judged (.iv)").required();
  check.number("--rate", options->rate, {500, 8000}, "Ticks per second at which it is to be felt")
      .type("HZ")
      .showDefault();
  check.json(options->json);
}

}  // namespace haptiv
