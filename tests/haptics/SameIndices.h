#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "haptics/scene/HapticScene.h"

namespace haptiv::testing {

inline void expectSameTree(const BoundingTree& a, const BoundingTree& b) {
  EXPECT_EQ(a.size(), b.size());
  EXPECT_EQ(a.origin(), b.origin());
  ASSERT_EQ(a.nodes().size(), b.nodes().size());
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    const BoxNode &one = a.nodes()[i], &other = b.nodes()[i];
    ASSERT_EQ(std::memcmp(one.low, other.low, sizeof one.low), 0) << "node " << i;
    ASSERT_EQ(std::memcmp(one.high, other.high, sizeof one.high), 0) << "node " << i;
    ASSERT_EQ(std::memcmp(one.child, other.child, sizeof one.child), 0) << "node " << i;
  }
}

inline void expectSameIndex(const ShapeIndex& a, const ShapeIndex& b) {
  expectSameTree(a.tree, b.tree);
  EXPECT_EQ(a.byId, b.byId);
  ASSERT_EQ(a.entries.size(), b.entries.size());
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    const ShapeIndex::Entry &one = a.entries[i], &other = b.entries[i];
    ASSERT_EQ(one.shape, other.shape);
    ASSERT_EQ(one.isStraight, other.isStraight);
    ASSERT_EQ(one.isUpright, other.isUpright);
    ASSERT_EQ(std::memcmp(&one.box, &other.box, sizeof one.box), 0);  // NaN, too
  }
}

/// A scene's indices, bit for bit as computeBounds makes them: then every query finds the same, in the same order.
inline void expectIndicesAsAnew(const HapticScene& scene) {
  HapticScene anew = scene;
  computeBounds(anew);
  expectSameIndex(scene.wallIndex, anew.wallIndex);
  expectSameIndex(scene.zoneIndex, anew.zoneIndex);
  expectSameTree(scene.meshIndex.tree, anew.meshIndex.tree);
  EXPECT_EQ(scene.meshIndex.wall, anew.meshIndex.wall);
}

}  // namespace haptiv::testing
