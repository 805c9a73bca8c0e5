#pragma once

#include <Inventor/nodes/SoNode.h>

namespace haptiv {

/// A calm light gradient over the whole picture. To be traversed before anything else is drawn, outside of caches.
SoNode* makeBackground();

}  // namespace haptiv
