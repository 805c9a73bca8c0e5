#pragma once

#include <Inventor/nodes/SoNode.h>

namespace haptiv {

/// A calm light gradient over the whole picture. Stands before all else that is drawn.
SoNode* makeBackground();

}  // namespace haptiv
