#pragma once

#include <cstddef>

namespace haptiv {

/// Has the processor bring something from memory that will soon be read, while it does other things. It changes nothing
/// but the time: of a large mesh, hardly anything near a place that is new is in the caches. Realtime-safe: yes.
template <typename T>
void fetch(const T& soonRead) noexcept {
  constexpr std::size_t kLine = 64;
  const char* begin = reinterpret_cast<const char*>(&soonRead);
  for (std::size_t at = 0; at < sizeof(T); at += kLine) __builtin_prefetch(begin + at);
}

}  // namespace haptiv
