#pragma once

#include <memory>
#include <vector>

#include "haptics/bytes/ByteReader.h"
#include "haptics/shapes/Shape.h"

namespace haptiv {

inline constexpr std::uint32_t kNoMesh = 0xffffffffU;  ///< in place of a mesh's number

/// Reads shapes, whose meshes stand in the order in which shapes first name them: one scene has one form.
class ShapeReader {
 public:
  /// @param known  so many of the meshes were named by earlier scenes
  ShapeReader(ByteReader& in, const std::vector<std::shared_ptr<const TriangleMesh>>& meshes, std::size_t known)
      : in_(in), meshes_(meshes), named_(known) {}

  Shape read() {
    Shape shape;
    const std::uint8_t kind = in_.u8();
    if (kind > static_cast<std::uint8_t>(Shape::Kind::mesh)) in_.fail("unknown kind of shape");
    shape.kind = static_cast<Shape::Kind>(kind);
    in_.matrix(shape.centre);
    in_.matrix(shape.axes);
    if (shape.kind == Shape::Kind::mesh) shape.mesh = readMeshNumber();
    return shape;
  }
  bool allNamed() const { return named_ == meshes_.size(); }

 private:
  std::shared_ptr<const TriangleMesh> readMeshNumber() {
    const std::uint32_t number = in_.u32();
    if (number == kNoMesh) return nullptr;
    if (number == named_ && number < meshes_.size()) ++named_;
    if (number >= named_) in_.fail("a mesh that is not there");
    return meshes_[number];
  }

  ByteReader& in_;
  const std::vector<std::shared_ptr<const TriangleMesh>>& meshes_;
  std::size_t named_;
};

}  // namespace haptiv
