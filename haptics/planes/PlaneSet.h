#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <numeric>

namespace haptiv {

using PlaneSet = std::uint32_t;  ///< some of up to 32 planes: a bit for each

/// How many planes are in it: 4 where there are more than three. Realtime-safe: yes.
inline int sizeUpToThree(PlaneSet planes) noexcept {
  const PlaneSet butOne = planes & (planes - 1), butTwo = butOne & (butOne - 1), butThree = butTwo & (butTwo - 1);
  return (planes != 0) + (butOne != 0) + (butTwo != 0) + (butThree != 0);
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
