#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <utility>

namespace haptiv {

/// Hands the newest value from one writer thread to one reader thread; neither ever waits.
///
/// A value that is overwritten before it is read is lost: for state, not for events. What a new value displaces is
/// destroyed by the writer, so a shared_ptr passed this way dies on the writer's side.
template <typename T>
class TripleBuffer {
 public:
  TripleBuffer() = default;
  explicit TripleBuffer(const T& initial) { slots_.fill(initial); }
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  /// Thread: the writer.  Realtime-safe: as assigning a T is.
  void write(T value) {
    slots_[back_] = std::move(value);
    back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex;
  }

  /// Takes the newest value, if there is one not yet read. Thread: the reader.  Realtime-safe: yes.
  bool update() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }

  /// The value that the last update took. Thread: the reader.
  const T& read() const noexcept { return slots_[front_]; }

 private:
  static constexpr std::uint32_t kIndex = 3;
  static constexpr std::uint32_t kFresh = 4;

  std::array<T, 3> slots_{};
  alignas(64) std::uint32_t back_ = 0;
  alignas(64) std::atomic<std::uint32_t> middle_ = 1;
  alignas(64) std::uint32_t front_ = 2;
};

}  // namespace haptiv
