#include "scenegraph/compiling/meshes/MeshCache.h"

#include <utility>

namespace haptiv {

std::shared_ptr<const TriangleMesh> MeshCache::find(ShapeId id, const MeshSource& source) {
  const auto known = known_.find(id);
  if (known == known_.end() || known->second.source != source) return nullptr;
  auto mesh = known->second.mesh;
  used_.insert(known_.extract(known));
  return mesh;
}

void MeshCache::keep(ShapeId id, MeshSource source, std::shared_ptr<const TriangleMesh> mesh) {
  used_.insert_or_assign(id, Entry{std::move(source), std::move(mesh)});
}

void MeshCache::forgetUnused() {
  known_ = std::exchange(used_, {});
}

}  // namespace haptiv
