#pragma once

#include <Inventor/SoType.h>

namespace haptiv {

/// From now on Coin makes the replacement where it made a Node: one derived from it that declares no type of its own,
/// so that it is written, searched for and copied as a Node, and files stay what they are. Thread: GUI.
template <typename Node, typename Replacement>
void replaceNode() {
  SoType::overrideType(Node::getClassTypeId(), []() -> void* { return new Replacement; });
}

}  // namespace haptiv
