#include "scenegraph/reading/files/PictureLoader.h"

#include <Inventor/SbImage.h>
#include <Inventor/VRMLnodes/SoVRMLImageTexture.h>
#include <Inventor/nodes/SoTexture2.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "scenegraph/isolation/Isolated.h"
#include "scenegraph/reading/files/SceneBytes.h"

namespace haptiv {
namespace {

/// Of a picture, for the way between processes; its pixels follow.
struct Head {
  short width, height;
  int components;
};

std::string packed(const Picture& picture) {
  const Head head{picture.width, picture.height, picture.components};
  std::string text(sizeof head, '\0');
  std::memcpy(text.data(), &head, sizeof head);
  return text + picture.pixels;
}

Picture unpacked(const std::string& text) {
  Head head{};
  if (text.size() >= sizeof head) std::memcpy(&head, text.data(), sizeof head);
  Picture picture{head.width, head.height, head.components, text.substr(std::min(text.size(), sizeof head))};
  const bool isSound = head.width > 0 && head.height > 0 && head.components >= 1 && head.components <= 4;
  const std::size_t size =
      isSound ? std::size_t(head.width) * std::size_t(head.height) * std::size_t(head.components) : 0;
  if (size == 0 || picture.pixels.size() != size) throw std::runtime_error("it has no pixels");
  return picture;
}

/// Coin takes a texture with an image for one without a file, and would write the image.
void show(SoTexture2& texture, const SbVec2s& size, const Picture& picture, const unsigned char* pixels) {
  texture.image.setValue(size, picture.components, pixels);
  texture.image.setDefault(TRUE);
  texture.filename.setDefault(FALSE);
}

}  // namespace

bool PictureLoader::takes(const SoNode* node) const {
  return decode_ && (dynamic_cast<const SoTexture2*>(node) || dynamic_cast<const SoVRMLImageTexture*>(node));
}

PictureLoader::Loaded PictureLoader::decode(const std::filesystem::path& path) {
  if (hasCrashed_) return {{}, "another picture has stopped the decoder"};
  const SceneBytes contents = readSceneBytes(path);
  if (!contents.fault.empty()) return {{}, contents.fault};
  // What it throws comes as a result; a fault is a crash.
  const Isolated made = runIsolated([&] {
    tellProgress("decodes a picture");
    try {
      return "1" + packed(decode_(contents.bytes));
    } catch (const std::runtime_error& error) {
      return std::string("0") + error.what();
    }
  });
  hasCrashed_ = !made.fault.empty();
  if (hasCrashed_) return {{}, "its decoder crashes or takes too long: save the picture anew"};
  const std::string rest = made.result.substr(1);
  if (made.result.front() == '0') return {{}, rest};
  try {
    return {unpacked(rest), {}};
  } catch (const std::runtime_error& error) {
    return {{}, error.what()};
  }
}

std::string PictureLoader::load(SoNode* node, const std::filesystem::path& path) {
  auto known = known_.find(path);
  if (known == known_.end()) known = known_.emplace(path, decode(path)).first;
  const Picture& picture = known->second.picture;
  if (!known->second.fault.empty()) return known->second.fault;
  const SbVec2s size(picture.width, picture.height);
  const auto* pixels = reinterpret_cast<const unsigned char*>(picture.pixels.data());
  if (auto* texture = dynamic_cast<SoTexture2*>(node)) show(*texture, size, picture, pixels);
  if (auto* texture = dynamic_cast<SoVRMLImageTexture*>(node))
    texture->setImage(SbImage(pixels, size, picture.components));
  return {};
}

}  // namespace haptiv
