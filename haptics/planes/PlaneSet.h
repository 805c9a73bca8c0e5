#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <numeric>

namespace haptiv {

using PlaneSet = std::uint32_t;  ///< some of up to 32 planes: a bit for each

/// How many planes are in it: 4 where there are more than three. Realtime-safe: yes.
inline int sizeUpToThree(PlaneSet planes) noexcept {
  int size = 0;
  for (; size < 4 && planes != 0; ++size) planes &= planes - 1;
  return size;
}

/// The numbers of its planes, as many as it has. Realtime-safe: yes.
template <std::size_t Size>
std::array<std::size_t, Size> membersOf(PlaneSet planes) noexcept {
  std::array<std::size_t, Size> of;
  if (planes == (PlaneSet{1} << Size) - 1) [[likely]] {  // what comes next need not wait for the numbers
    std::iota(of.begin(), of.end(), std::size_t{0});
    return of;
  }
  for (std::size_t& each : of) {
    each = static_cast<std::size_t>(std::countr_zero(planes));
    planes &= planes - 1;
  }
  return of;
}

}  // namespace haptiv
