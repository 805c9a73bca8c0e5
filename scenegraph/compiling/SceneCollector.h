#pragma once

#include <Inventor/actions/SoCallbackAction.h>

#include <functional>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

#include "haptics/HapticScene.h"
#include "scenegraph/Diagnostic.h"

namespace haptiv {

class SoHapticDevice;
class SoHapticProperty;
class SoHapticTool;

/// Walks through a scene graph once, as Coin does (Switch, USE, arrays), and gathers what is felt. Thread: GUI.
class SceneCollector {
 public:
  /// @param idOf  gives each felt shape its id, from the nodes on the way to it
  explicit SceneCollector(std::function<ShapeId(const SoPath&)> idOf);

  void collect(SoNode* root);

  HapticScene scene;        ///< without version and bounds
  Diagnostics diagnostics;  ///< with node and source; without file and line

  /// Null where the scene has none.
  const SoHapticTool* tool() const { return tool_; }

 private:
  static SoCallbackAction::Response onProperty(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onTool(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onDevice(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onShape(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onDragger(void* self, SoCallbackAction* action, const SoNode* node);

  void takeTool(const SoHapticTool& tool);
  void takeDevice(const SoHapticDevice& device);
  void takeShape(const SoHapticProperty& property, const SoNode* node, SoCallbackAction& action);
  void add(const SoHapticProperty& property, const Shape& shape, SoCallbackAction& action);
  void check(const SoNode* node);
  void checkPlace(const SoNode* node, SoCallbackAction& action);
  /// The same of the same node is said once, however often USE repeats it.
  void say(Diagnostic::Severity severity, const SoNode* node, const std::string& message);

  std::function<ShapeId(const SoPath&)> idOf_;
  const SoHapticTool* tool_ = nullptr;
  const SoHapticDevice* device_ = nullptr;
  std::unordered_set<const SoNode*> checked_;
  std::set<std::pair<const SoNode*, std::string>> said_;
};

}  // namespace haptiv
