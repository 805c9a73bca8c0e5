#pragma once

#include <memory>

#include "haptics/scene/SceneIndexer.h"
#include "scenegraph/compiling/KnownSeparators.h"
#include "scenegraph/compiling/MetNodes.h"
#include "scenegraph/compiling/PathIds.h"
#include "scenegraph/compiling/meshes/MeshCache.h"

namespace haptiv {

/// What the compilations of a document leave to the next one. Thread: GUI.
struct SceneMemory {
  PathIds ids;
  MetNodes met;  ///< the haptic ones
  MeshCache meshes;
  KnownSeparators separators;                ///< as they are in `scene`
  SceneIndexer indexer;                      ///< as it has indexed `scene`
  std::shared_ptr<const HapticScene> scene;  ///< the newest that was valid; null: none yet
};

}  // namespace haptiv
