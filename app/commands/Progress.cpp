#include "app/commands/Progress.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace haptiv {
namespace {

constexpr std::size_t kBar = 30;  // [characters]
constexpr const char* kBackToBlankLine = "\r\x1b[K";

}  // namespace

Progress::Progress(std::size_t steps) : steps_(steps), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::step(const std::string& name) {
  ++step_;
  const std::string count = std::to_string(step_) + "/" + std::to_string(steps_);
  if (!terminal_) {
    std::cerr << count + " " + name + "\n" << std::flush;
    return;
  }
  const std::size_t full = std::min(kBar, kBar * (step_ - 1) / std::max<std::size_t>(1, steps_));
  std::cerr << kBackToBlankLine
            << "[" + std::string(full, '#') + std::string(kBar - full, '.') + "] " + count + " " + name << std::flush;
  drawn_ = true;
}

void Progress::finish() {
  if (drawn_) std::cerr << kBackToBlankLine << std::flush;
  drawn_ = false;
}

}  // namespace haptiv
