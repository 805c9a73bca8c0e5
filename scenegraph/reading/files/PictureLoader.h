#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scenegraph/DecodePicture.h"

class SoNode;

namespace haptiv {

/// Gives textures their pictures. Each file is decoded once, in a process of its own; where that crashes or takes too
/// long, no more are decoded. Thread: GUI.
class PictureLoader {
 public:
  /// @param decode  empty: nothing is decoded
  explicit PictureLoader(DecodePicture decode) : decode_(std::move(decode)) {}

  /// Whether the node takes a picture from here; others have Coin read it.
  bool takes(const SoNode* node) const;
  /// Why the node does not have the picture now; empty where it has. What the file is called stays as it is.
  std::string load(SoNode* node, const std::filesystem::path& path);

 private:
  struct Loaded {
    Picture picture;
    std::string fault;
  };
  Loaded decode(const std::filesystem::path& path);

  DecodePicture decode_;
  bool hasCrashed_ = false;
  std::map<std::filesystem::path, Loaded> known_;
};

}  // namespace haptiv
