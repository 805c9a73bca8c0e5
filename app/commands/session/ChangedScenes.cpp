#include "app/commands/session/ChangedScenes.h"

#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/fields/SoSFString.h>

#include <algorithm>
#include <set>

#include "app/commands/ExitCode.h"
#include "app/commands/scene/LoadedScene.h"
#include "app/commands/session/SceneDifference.h"
#include "scenegraph/CoinMessages.h"
#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticTool.h"

namespace haptiv {
namespace {

std::set<SoNode*> nodesCalled(SoNode* root, const std::string& name) {
  SoSearchAction search;
  search.setType(SoNode::getClassTypeId());
  search.setInterest(SoSearchAction::ALL);
  search.setSearchingAll(TRUE);
  search.apply(root);
  std::set<SoNode*> nodes;
  for (int i = 0; i < search.getPaths().getLength(); ++i) {
    SoNode* node = search.getPaths()[i]->getTail();
    const auto* label = dynamic_cast<const SoSFString*>(node->getField("label"));
    if (name == node->getName().getString() || (label && name == label->getValue().getString())) nodes.insert(node);
  }
  return nodes;
}

bool isAsLogged(const SoNode* node, const std::string& field) {
  return node->isOfType(SoHapticDevice::getClassTypeId()) ||
         (node->isOfType(SoHapticTool::getClassTypeId()) && field == "home");
}

// False: the scene has no node of this name. A Separator and the surface in it may bear the same one: the field
// decides.
bool apply(SoNode* root, const PropertyChange& change) {
  const std::set<SoNode*> nodes = nodesCalled(root, change.node);
  const std::string what = "--set " + change.node + "." + change.field + "=" + change.value + ": ";
  bool applied = false;
  for (SoNode* node : nodes) {
    SoField* field = node->getField(change.field.c_str());
    if (!field) continue;
    if (isAsLogged(node, change.field))
      throw CommandFailure(kWrongUsage, what + "arm and start are those of the log; run the changed scene instead");
    field->disconnect();                     // from a prototype's field (IS), whose value would come back
    const CoinMessages said{std::string()};  // of a number that it replaces by 0, too
    if (!field->set(change.value.c_str()) || !said.diagnostics().empty())
      throw CommandFailure(kWrongUsage, what + "this is no value of that field");
    applied = true;
  }
  if (!nodes.empty() && !applied)
    throw CommandFailure(kWrongUsage, what + "a " + (*nodes.begin())->getTypeId().getName().getString() +
                                          " has no such field; docs/nodes.md lists its fields");
  return applied;
}

std::shared_ptr<const HapticScene> compile(const SceneFile& file) {
  Diagnostics diagnostics = file.diagnostics;
  CompiledScene compiled;
  if (file.root && !hasErrors(diagnostics)) {  // Coin reads beyond memory where indices are wrong
    compiled = SceneCompiler().compile(file);
    diagnostics.insert(diagnostics.end(), compiled.diagnostics.begin(), compiled.diagnostics.end());
  }
  if (!compiled.scene || hasErrors(diagnostics)) {
    tell(diagnostics);
    throw CommandFailure(kNotSo, "the logged scene cannot be felt with what --set changes; see the lines above");
  }
  return compiled.scene;
}

// Older logs do not hold what is included. Where many edits of a large scene share one text, that may be another one.
void requireIncluded(const SceneFile& file, const HapticScene& read, const HapticScene& logged) {
  if (read.walls.size() == logged.walls.size() && read.zones.size() == logged.zones.size()) return;
  const auto isMissing = [](const Diagnostic& each) {
    return each.node.starts_with("File") || each.node.starts_with("WWWInline") || each.node.starts_with("VRMLInline");
  };
  if (std::ranges::none_of(file.diagnostics, isMissing)) return;
  tell(file.diagnostics);
  throw CommandFailure(kCouldNot,
                       "--set: what the logged scene includes is not found from here; run haptiv in the folder "
                       "of the scene, which haptiv info names");
}

}  // namespace

PropertyChange parseChange(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.rfind('.', equals);
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equals)
    throw CommandFailure(kWrongUsage, "--set " + text + ": write NODE.FIELD=VALUE, such as Wall.stiffness=500");
  return {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
}

std::vector<LoggedScene> withChanges(const std::vector<LoggedScene>& scenes,
                                     const std::vector<PropertyChange>& changes) {
  std::vector<bool> used(changes.size(), false);
  std::vector<LoggedScene> changed = scenes;
  for (LoggedScene& each : changed) {
    SceneFile file = readSceneText(each.text, "the logged scene");
    const auto before = compile(file);
    requireIncluded(file, *before, each.scene);
    for (std::size_t i = 0; i < changes.size(); ++i)
      if (apply(file.root.get(), changes[i])) used[i] = true;
    judgeAgain(file);
    const auto after = compile(file);
    carryDifference(each.scene, *before, *after);
  }
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (!used[i])
      throw CommandFailure(kWrongUsage, "--set: no node of the logged scene has the DEF name or label " +
                                            changes[i].node + "; haptiv info names the scene");
  return changed;
}

}  // namespace haptiv
