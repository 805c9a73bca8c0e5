#include "tests/haptics/usb/ThreadTimes.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace haptiv::test {

std::map<std::string, double> threadTimes() {
  std::map<std::string, double> times;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    double onProcessor = 0;  // [ns]
    std::ifstream comm(task.path() / "comm"), schedstat(task.path() / "schedstat");
    if (!std::getline(comm, name) || !(schedstat >> onProcessor)) {
      if (!std::filesystem::exists(task.path())) continue;  // it has just ended
      throw std::runtime_error("this kernel does not count the threads' time: it needs CONFIG_SCHED_INFO");
    }
    times[name] += 1e-9 * onProcessor;
  }
  return times;
}

}  // namespace haptiv::test
