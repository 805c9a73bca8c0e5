#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace haptiv {

constexpr std::uintmax_t kMaxSceneBytes = 256u << 20;  ///< some four million triangles as text

/// What a file holds, unpacked where it is gzipped.
struct SceneBytes {
  std::string bytes;
  std::string fault;  ///< why it cannot be had, and what to do; empty where it can
};

/// Only regular files are opened; nothing larger than kMaxSceneBytes, packed or unpacked, is taken in.
SceneBytes readSceneBytes(const std::filesystem::path& path);

/// The same of what is in memory already.
SceneBytes unpackScene(std::string bytes);

}  // namespace haptiv
