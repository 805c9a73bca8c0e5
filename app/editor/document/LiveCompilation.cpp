#include "app/editor/document/LiveCompilation.h"

#include <exception>
#include <utility>

#include "scenegraph/judging/SceneJudge.h"

namespace haptiv {

void LiveCompilation::setProgress(CompileProgress progress) {
  compiler_.setProgress(std::move(progress));
}

void LiveCompilation::replaceBy(const SceneFile& file) {
  compiled_ = {};
  forgetDevice();
  outdate();
  compile(file);
  judge(file);
}

void LiveCompilation::locate(const SceneFile& file) {
  for (Diagnostic& each : compiled_.diagnostics) haptiv::locate(each, file);
  isToJudge_ = true;
  judge(file);
}

void LiveCompilation::compile(const SceneFile& file) {
  if (!isToCompile_) return;
  CompiledScene next = compiler_.compile(file);
  isValid_ = next.scene != nullptr;
  if (!isValid_) next.scene = compiled_.scene;
  compiled_ = std::move(next);
  isToCompile_ = false;
  isToJudge_ = true;
}

void LiveCompilation::judge(const SceneFile& file) {
  if (!isToJudge_) return;
  const Diagnostics judgement = isValid_ ? judgementOf(file) : Diagnostics();
  diagnostics_ = file.diagnostics;
  diagnostics_.insert(diagnostics_.end(), compiled_.diagnostics.begin(), compiled_.diagnostics.end());
  diagnostics_.insert(diagnostics_.end(), judgement.begin(), judgement.end());
  sortByPlace(diagnostics_);
  isToJudge_ = false;
}

// Called while a handle is dragged: the description is read only when it is another.
Diagnostics LiveCompilation::judgementOf(const SceneFile& file) {
  const HapticScene& scene = *compiled_.scene;
  Diagnostics found;
  try {
    if (deviceName_ != scene.device.description) {
      device_ = loadDeviceDescription(scene.device.description, file.path);
      deviceName_ = scene.device.description;
    }
    found = judgeScene({scene, compiled_.origins, device_, rate_});
  } catch (const std::exception& error) {
    found.push_back({Diagnostic::Severity::error, {}, 0, "HapticDevice", error.what(), compiled_.origins.device});
  }
  for (Diagnostic& each : found) haptiv::locate(each, file);
  return found;
}

}  // namespace haptiv
