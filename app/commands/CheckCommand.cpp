#include "app/commands/CheckCommand.h"

#include "app/commands/ExitCode.h"
#include "app/commands/LoadedScene.h"
#include "app/commands/Report.h"

namespace haptiv {

int checkScene(const CheckOptions& options) {
  initSceneGraph();
  const LoadedScene loaded = loadScene(options.scene);
  const auto count = [&loaded](auto member) -> Report::Value {
    if (!loaded.compiled.scene) return nullptr;
    return std::uint64_t{((*loaded.compiled.scene).*member).size()};
  };
  Report report;
  report.add("walls", count(&HapticScene::walls));
  report.add("zones", count(&HapticScene::zones));
  report.add("triangles", loaded.file.root ? Report::Value(std::uint64_t{loaded.compiled.triangles}) : nullptr);
  report.add("errors", listOf(loaded.diagnostics, Diagnostic::Severity::error));
  report.add("warnings", listOf(loaded.diagnostics, Diagnostic::Severity::warning));
  if (!options.json) tell(loaded.diagnostics);
  report.print(options.json);
  return hasErrors(loaded.diagnostics) ? kNotSo : kGood;
}

}  // namespace haptiv
