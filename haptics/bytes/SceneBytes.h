#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Scenes as bytes, for the session log: every double bit for bit, little-endian, with a format number.
///
/// A mesh may be large, and most edits leave it as it is: it is written with the first scene that has it, and named by
/// a number in those that follow. Meshes are the same where the pointer is.
class SceneEncoder {
 public:
  std::vector<std::byte> encode(const HapticScene& scene);

 private:
  struct Written {
    std::weak_ptr<const TriangleMesh> mesh;  ///< keeps another one from having the same address
    std::uint32_t number;
  };
  std::unordered_map<const TriangleMesh*, Written> written_;
  std::uint32_t next_ = 0;
};

/// Reads what a SceneEncoder wrote, in the same order. Throws std::runtime_error that says what is wrong at which byte;
/// the bytes may be hostile.
class SceneDecoder {
 public:
  HapticScene decode(std::span<const std::byte> bytes);

 private:
  std::vector<std::shared_ptr<const TriangleMesh>> meshes_;
};

/// A single scene.
std::vector<std::byte> toBytes(const HapticScene& scene);
HapticScene sceneFromBytes(std::span<const std::byte> bytes);

}  // namespace haptiv
