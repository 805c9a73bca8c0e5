#pragma once

#include <Inventor/SbBasic.h>

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "scenegraph/NodeRef.h"

class SbVec2f;
class SbVec3f;
class SbVec4f;
class SoSeparator;
class SoState;

namespace haptiv {

/// A NURBS surface, and what is in force where it stands: all that its triangles depend on where profiles trim it. It
/// refers to values in the graph: it is to be used while that is left as it is.
class TrimmedPlace {
 public:
  /// Numbers that Coin gives to contents: of the surface, its points, and what trims it.
  using Key = std::vector<SbUniqueId>;

  /// Of the surface that an action is at; nothing where no profile is in force.
  static std::optional<TrimmedPlace> of(const SoNode* surface, SoState* state);

  /// Empty where more than a thousand profiles trim it: it is not to be cut.
  const Key& key() const { return key_; }
  const SoNode* surface() const { return surface_; }

  /// A graph of its own that holds what is here, as Coin's own node: without a place, and seen from nowhere.
  /// @param fineness  0 to 1, as SoComplexity has it
  NodeRef<SoSeparator> graph(float fineness) const;

 private:
  const SoNode* surface_ = nullptr;
  Key key_;
  std::vector<SoNode*> profiles_;
  std::variant<std::span<const SbVec3f>, std::span<const SbVec4f>> points_;
  std::variant<std::span<const SbVec2f>, std::span<const SbVec3f>> profilePoints_;
};

}  // namespace haptiv
