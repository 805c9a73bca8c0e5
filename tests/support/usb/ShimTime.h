#pragma once

#include <cstdint>

namespace haptiv::test {

/// Processor time that the bench takes on the threads of those who call it, in the functions of libc that it replaces:
/// a kernel would take time there too, but not this. Counted only once `count` has been called, as each look at a
/// thread's clock is a system call; what the looks themselves take is counted with the rest. Thread: any.
class ShimTime {
 public:
  /// From now on.
  static void count() noexcept;
  /// Of all threads so far [s].
  static double taken() noexcept;

  /// A stretch of the bench's own work.
  ShimTime() noexcept;
  ~ShimTime();
  ShimTime(const ShimTime&) = delete;
  ShimTime& operator=(const ShimTime&) = delete;

 private:
  std::int64_t start_ = 0;  // [ns] by the thread's clock
};

}  // namespace haptiv::test
