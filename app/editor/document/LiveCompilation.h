#pragma once

#include <string>
#include <utility>

#include "device/described/DeviceDescription.h"
#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {

/// What a document's graph comes to: its last compilation, the device that it names, and what ails it. Compiled and
/// judged when asked, and only where the graph is newer. Thread: GUI.
class LiveCompilation {
 public:
  void setProgress(CompileProgress progress);
  /// Of the sessions that it is judged for [Hz]; holds from the next compilation on.
  void setRate(double rate) { rate_ = rate; }

  /// The graph has changed.
  void outdate() { isToCompile_ = true; }
  /// The scene's folder, from which the device's file is named, or that file may be another one.
  void forgetDevice() { deviceName_.clear(); }
  /// The nodes stand on other lines, or in another file.
  void locate(const SceneFile& file);
  /// Compiles and judges another file's graph.
  void replaceBy(const SceneFile& file);

  /// Compiles the graph if it is newer than its compilation.
  void compile(const SceneFile& file);
  /// Judges the compilation if it is newer than its judgement.
  void judge(const SceneFile& file);

  /// Its scene is the last valid one, which stays in force while there are errors.
  const CompiledScene& compiled() const { return compiled_; }
  /// The device that the scene names; where there is none such, the one before, or the built-in one.
  const DeviceDescription& device() const { return device_; }
  /// Of opening, compiling and judging, together.
  const Diagnostics& diagnostics() const { return diagnostics_; }
  /// In their place until the next judgement: of a file that could not be opened.
  void setDiagnostics(Diagnostics diagnostics) { diagnostics_ = std::move(diagnostics); }

 private:
  Diagnostics judgementOf(const SceneFile& file);

  SceneCompiler compiler_;
  CompiledScene compiled_;
  Diagnostics diagnostics_;
  DeviceDescription device_;  // on which the scene is judged ...
  std::string deviceName_;    // ... under this name or path
  double rate_ = 1000;        // ... at so many ticks a second [Hz]
  bool isToCompile_ = false;  // the graph is newer than its compilation ...
  bool isToJudge_ = false;    // ... and this newer than its judgement
  bool isValid_ = false;      // the last compilation has a scene of its own
};

}  // namespace haptiv
