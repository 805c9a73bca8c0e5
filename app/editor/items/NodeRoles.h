#pragma once

#include <Inventor/nodes/SoNode.h>

#include <vector>

namespace haptiv {

/// What a walk for the scene's items does about a node.
enum class Role : unsigned char {
  unknown,
  property,
  tool,
  device,
  material,
  baseColor,
  shape,
  separator,
  group,
  other
};

/// Roles, looked up by the number that Coin gives a node's type: a scene may have half a million nodes.
class NodeRoles {
 public:
  Role operator()(const SoNode& node);

 private:
  std::vector<Role> known_;
};

}  // namespace haptiv
