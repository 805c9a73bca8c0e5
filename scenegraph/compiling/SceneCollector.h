#pragma once

#include <Inventor/actions/SoCallbackAction.h>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "haptics/scene/HapticScene.h"
#include "scenegraph/Diagnostic.h"
#include "scenegraph/compiling/FeltShape.h"
#include "scenegraph/compiling/PlainSeparator.h"
#include "scenegraph/compiling/SceneMemory.h"
#include "scenegraph/compiling/ShapeOrigin.h"
#include "scenegraph/compiling/meshes/TriangleSoup.h"

namespace haptiv {

class SoHapticDevice;
class SoHapticProperty;
class SoHapticTool;

/// Walks through a scene graph once, as Coin does (Switch, USE, arrays), and gathers what is felt: exact shapes as
/// such, all others by their triangles. Of levels of detail the first is felt, the finest. Thread: GUI.
class SceneCollector {
 public:
  using Progress = std::function<void(std::size_t shapes, std::size_t triangles)>;

  static constexpr std::size_t kMaxTriangles = 4'000'000;  ///< felt ones: some hundred bytes each with their index

  /// @param memory  of the compilation before; of this one afterwards, but for scene and indexer
  explicit SceneCollector(SceneMemory& memory, Progress progress = {}, std::size_t mostTriangles = kMaxTriangles);

  void collect(SoNode* root);

  HapticScene scene;        ///< without version and bounds
  SceneOrigins origins;     ///< of what is in `scene`
  Diagnostics diagnostics;  ///< with node and source; without file and line
  KeptRuns keptWalls;       ///< what is known to be as in the scene before
  KeptRuns keptZones;

 private:
  static SoCallbackAction::Response onProperty(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onTool(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onDevice(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onSeparator(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onShape(void* self, SoCallbackAction* action, const SoNode* node);
  static void onTriangle(void* self, SoCallbackAction* action, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
                         const SoPrimitiveVertex* c);
  static SoCallbackAction::Response onShapeEnd(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onLevels(void* self, SoCallbackAction* action, const SoNode* node);
  static SoCallbackAction::Response onDragger(void* self, SoCallbackAction* action, const SoNode* node);

  /// Goes through a Separator as Coin does; what is plain below it is read without Coin.
  void walk(const SoSeparator& separator, SoCallbackAction& action);
  Surroundings surroundings(PathIds::Way way, SoCallbackAction& action) const;
  /// False: it is none that can be read without Coin.
  bool takePlain(const SoSeparator& separator, const Surroundings& around);
  void takeRead(const SoSeparator& separator, const Surroundings& around);
  void takeKnown(const KnownSeparators::Separator& known, const Surroundings& around);
  void takeTool(const SoHapticTool& tool);
  void takeDevice(const SoHapticDevice& device);
  /// Whether its triangles are wanted, too.
  bool takeShape(const SoNode* node, SoCallbackAction& action);
  bool beginMesh(const SoNode* node, SoCallbackAction& action);
  void endMesh(const SoNode* node, SoCallbackAction& action);
  void add(const FeltShape& felt, Shape shape);
  void tellProgress() const;
  void check(const SoNode* node);
  /// The same of a node that is known to have no fault.
  void note(const KnownSeparators::Property& property);
  void checkPlace(const SoNode* node, SoCallbackAction& action);
  /// The same of the same node is said once, however often USE repeats it.
  void say(Diagnostic::Severity severity, const SoNode* node, const std::string& message);

  /// A shape whose triangles are on their way.
  struct OpenMesh {
    ShapeId id = 0;
    MeshSource source;
    TriangleSoup soup;
    float complexityBefore = 0;
  };

  SceneMemory& memory_;
  Progress progress_;
  std::optional<OpenMesh> open_;
  std::size_t triangles_ = 0;
  std::size_t mostTriangles_;
  PlainSeparator plain_;                             // the one that is being read
  std::vector<KnownSeparators::Shape> plainShapes_;  // of the same ...
  std::vector<KnownSeparators::Property> plainProperties_;
  std::set<std::pair<const SoNode*, std::string>> said_;
};

}  // namespace haptiv
