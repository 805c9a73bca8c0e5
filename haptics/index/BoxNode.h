#pragma once

#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "haptics/index/FloatBox.h"

namespace haptiv {

/// Four boxes side by side, as they are tested together: two lines of cache.
struct alignas(64) BoxNode {
  static constexpr std::size_t kWidth = 4;
  static constexpr std::uint32_t kNone = 0xffffffffU;      ///< an empty place; no query touches its box
  static constexpr std::uint32_t kItemFlag = 0x80000000U;  ///< the rest of the number names an item, not a node

  float low[3][kWidth];
  float high[3][kWidth];
  std::uint32_t child[kWidth];

  /// Without boxes.
  static BoxNode empty() noexcept {
    constexpr float kNever = std::numeric_limits<float>::max();
    BoxNode node;
    for (std::size_t i = 0; i < kWidth; ++i) {
      node.set(i, {{kNever, kNever, kNever}, {-kNever, -kNever, -kNever}}, kNone);
    }
    return node;
  }

  void set(std::size_t place, const FloatBox& box, std::uint32_t newChild) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis][place] = box.low[axis];
      high[axis][place] = box.high[axis];
    }
    child[place] = newChild;
  }

  FloatBox box(std::size_t place) const noexcept {
    return {{low[0][place], low[1][place], low[2][place]}, {high[0][place], high[1][place], high[2][place]}};
  }

  /// One bit for each place without a node below it: an item's, or an empty one.
  unsigned withoutNode() const noexcept {
#ifdef __SSE2__
    const __m128i names = _mm_load_si128(reinterpret_cast<const __m128i*>(child));
    return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(names)));
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= child[i] >> 31U << i;
    return bits;
#endif
  }

  /// One bit for each box that has a point in common with `query`.
  unsigned touching(const FloatBox& query) const noexcept {
#ifdef __SSE2__
    __m128 apart = _mm_setzero_ps();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      apart = _mm_or_ps(apart, _mm_cmpgt_ps(_mm_load_ps(low[axis]), _mm_set1_ps(query.high[axis])));
      apart = _mm_or_ps(apart, _mm_cmplt_ps(_mm_load_ps(high[axis]), _mm_set1_ps(query.low[axis])));
    }
    return ~static_cast<unsigned>(_mm_movemask_ps(apart)) & 0xfU;
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) {
      bool apart = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        apart = apart || low[axis][i] > query.high[axis] || high[axis][i] < query.low[axis];
      }
      bits |= static_cast<unsigned>(!apart) << i;
    }
    return bits;
#endif
  }

  /// One bit for each box whose distance from `p`, squared, is `most` at most; true of boxes that are
  /// farther by no more than single precision rounds.
  unsigned within(const FloatBox& p, float most) const noexcept {
#ifdef __SSE2__
    __m128 sum = _mm_setzero_ps();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const __m128 below = _mm_sub_ps(_mm_load_ps(low[axis]), _mm_set1_ps(p.high[axis]));
      const __m128 above = _mm_sub_ps(_mm_set1_ps(p.low[axis]), _mm_load_ps(high[axis]));
      const __m128 gap = _mm_max_ps(_mm_max_ps(below, above), _mm_setzero_ps());
      sum = _mm_add_ps(sum, _mm_mul_ps(gap, gap));
    }
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(sum, _mm_set1_ps(most))));
#else
    const std::array<float, 4> squared = squaredDistances(p);
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= static_cast<unsigned>(squared[i] <= most) << i;
    return bits;
#endif
  }

  /// Squares of the distances from the point within `p` to the boxes; none is larger than it truly is by more than
  /// single precision rounds.
  std::array<float, 4> squaredDistances(const FloatBox& p) const noexcept {
    std::array<float, 4> sum{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < 4; ++i) {
        const float gap = std::max(std::max(low[axis][i] - p.high[axis], p.low[axis] - high[axis][i]), 0.0F);
        sum[i] = std::min(sum[i] + gap * gap, std::numeric_limits<float>::max());
      }
    }
    return sum;
  }
};

}  // namespace haptiv
