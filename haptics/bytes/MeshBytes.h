#pragma once

#include <memory>

#include "haptics/bytes/ByteReader.h"
#include "haptics/bytes/ByteWriter.h"
#include "haptics/meshes/TriangleMesh.h"

namespace haptiv {

/// What a mesh takes at least [bytes].
inline constexpr std::size_t kMeshSize = 4 + 3 * 24 + 4 + 12;

void write(ByteWriter& out, const TriangleMesh& mesh);

/// With its tree; the same bits as it was written. Throws as ByteReader does.
std::shared_ptr<const TriangleMesh> readMesh(ByteReader& in);

}  // namespace haptiv
