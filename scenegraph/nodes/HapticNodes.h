#pragma once

#include <Inventor/nodes/SoSubNode.h>

/// Registers a node class under its keyword, "HapticSurface" for SoHapticSurface.
///
/// Coin's public SO_NODE_INIT_CLASS registers the full class name: files would then be written with the prefix, and
/// the short form would not be read. With the short name registered, the short form is written and both are read.
#define HAPTIV_NODE_INIT_CLASS(class_, keyword_, parent_) \
  PRIVATE_COMMON_INIT_CODE(class_, keyword_, &class_::createInstance, parent_)

namespace haptiv {

/// Registers the element and every haptic node with Coin, once; after SoDB::init().
void initHapticNodes();

}  // namespace haptiv
