#pragma once

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstddef>
#include <cstdint>

namespace haptiv {

/// A stream in which every value matters, from one writer thread to one reader thread. Where the reader falls
/// behind, values are dropped and counted; the writer never waits.
template <typename T>
class RecordRing {
 public:
  /// Allocates all that it will ever need, and touches it, so that the writer meets no page that is not there yet.
  /// @param capacity  values that fit in
  explicit RecordRing(std::size_t capacity) : queue_(capacity) {
    while (queue_.push(T{})) {
    }
    queue_.reset();
  }

  /// Thread: the writer.  Realtime-safe: yes.
  void push(const T& value) noexcept {
    if (!queue_.push(value)) dropped_.fetch_add(1, std::memory_order_relaxed);
  }

  /// Calls `consume(const T&)` with every value that is there, in order. Thread: the reader.
  template <typename Consume>
  std::size_t drain(Consume&& consume) {
    return queue_.consume_all(consume);
  }

  /// How many values were lost so far. Thread-safe: yes.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  boost::lockfree::spsc_queue<T> queue_;
  std::atomic<std::uint64_t> dropped_ = 0;
};

}  // namespace haptiv
