#include "haptics/realtime/AwakeProcessor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>

namespace haptiv {

AwakeProcessor::AwakeProcessor() noexcept : file_(open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC)) {
  if (file_ < 0) return;
  const std::int32_t longest = 0;  // [us]; it holds while the file is open
  if (write(file_, &longest, sizeof longest) == sizeof longest) return;
  close(file_);
  file_ = -1;
}

AwakeProcessor::~AwakeProcessor() {
  if (file_ >= 0) close(file_);
}

}  // namespace haptiv
