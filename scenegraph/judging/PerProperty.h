#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "scenegraph/compiling/ShapeOrigin.h"

namespace haptiv {

/// The walls, or the zones, that one property node gives its values to.
struct PropertyGroup {
  const SoNode* property = nullptr;
  std::vector<std::size_t> members;  ///< indices into HapticScene::walls or ::zones
};

/// In the order in which the properties are met first.
inline std::vector<PropertyGroup> groupByProperty(const std::vector<ShapeOrigin>& origins) {
  std::vector<PropertyGroup> groups;
  std::unordered_map<const SoNode*, std::size_t> groupOf;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const auto [known, isNew] = groupOf.try_emplace(origins[i].property, groups.size());
    if (isNew) groups.push_back({origins[i].property, {}});
    groups[known->second].members.push_back(i);
  }
  return groups;
}

}  // namespace haptiv
