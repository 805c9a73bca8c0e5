#pragma once

#include <QString>

#include "app/editor/document/SceneDocument.h"

namespace haptiv {

/// How a wall with this property answers the tool of the scene: damping ratio (32), optimal stiffness (33), depth at
/// the device's peak force. Empty for what is no HapticSurface, and while the scene has never been valid.
QString wallDynamicsText(const SceneDocument& document, const SoNode* property);

}  // namespace haptiv
