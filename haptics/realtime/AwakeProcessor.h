#pragma once

namespace haptiv {

/// Keeps the processor from sleeping deeper than it wakes at once, while this lives: it asks Linux for a latency of 0
/// us in /dev/cpu_dma_latency. Mostly root alone may; where it is not permitted, nothing is kept, and nothing is wrong.
class AwakeProcessor {
 public:
  AwakeProcessor() noexcept;
  ~AwakeProcessor();
  AwakeProcessor(const AwakeProcessor&) = delete;
  AwakeProcessor& operator=(const AwakeProcessor&) = delete;

  bool isKept() const noexcept { return file_ >= 0; }

 private:
  int file_ = -1;
};

}  // namespace haptiv
