#include "app/commands/session/SessionPicture.h"

#include "app/view/drawn/HapticOverlay.h"
#include "app/view/picture/OffscreenPicture.h"

namespace haptiv {

QImage drawSession(const LoadedScene& loaded, const TickRecord& record) {
  constexpr int kWidth = 1280;
  constexpr int kHeight = 720;
  HapticOverlay overlay;
  overlay.setUp(*loaded.compiled.scene, loaded.device);
  overlay.show(record);
  const NodeRef<SoSeparator> root(new SoSeparator);
  root->addChild(loaded.file.root.get());
  root->addChild(overlay.root());
  return drawOffscreen(root.get(), kWidth, kHeight);
}

}  // namespace haptiv
