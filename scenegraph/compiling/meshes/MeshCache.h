#pragma once

#include <memory>
#include <unordered_map>

#include "haptics/scene/HapticScene.h"
#include "scenegraph/compiling/meshes/MeshSource.h"

namespace haptiv {

/// The meshes of the compilation before: an edit of one wall does not build all others again. Thread: GUI.
class MeshCache {
 public:
  /// The shape's mesh as it was; null where there is none, or where it would be another one now.
  std::shared_ptr<const TriangleMesh> find(ShapeId id, const MeshSource& source);
  void keep(ShapeId id, MeshSource source, std::shared_ptr<const TriangleMesh> mesh);
  /// Ends a compilation: what it has neither found nor kept is forgotten.
  void forgetUnused();

 private:
  struct Entry {
    MeshSource source;
    std::shared_ptr<const TriangleMesh> mesh;
  };
  std::unordered_map<ShapeId, Entry> known_, used_;
};

}  // namespace haptiv
