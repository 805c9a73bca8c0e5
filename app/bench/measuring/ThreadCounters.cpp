#include "app/bench/measuring/ThreadCounters.h"

#include <sched.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace haptiv {
namespace {

std::filesystem::path folderOf(int thread) {
  return std::filesystem::path("/proc/self/task") / std::to_string(thread);
}

}  // namespace

std::optional<int> realtimeThread() {
  std::optional<int> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", error)) {
    const int thread = std::stoi(entry.path().filename().string());
    if ((sched_getscheduler(thread) & ~SCHED_RESET_ON_FORK) != SCHED_FIFO) continue;
    if (found) return std::nullopt;
    found = thread;
  }
  return found;
}

std::optional<ThreadCounters> countersOf(int thread) {
  ThreadCounters counters;
  std::ifstream stat(folderOf(thread) / "stat");
  std::string line;
  if (!std::getline(stat, line)) return std::nullopt;
  // After the name, which may hold anything, in brackets: state, six numbers, flags, minor faults, those of children,
  // major faults (proc(5)).
  std::size_t at = line.rfind(')') + 2;
  for (int field = 3; field <= 12; ++field) {
    const std::size_t end = line.find(' ', at);
    if (field == 10 || field == 12) counters.pageFaults += std::stoull(line.substr(at, end - at));
    at = end + 1;
  }
  std::ifstream status(folderOf(thread) / "status");
  for (std::string word; status >> word;) {
    if (word == "nonvoluntary_ctxt_switches:") status >> counters.interruptions;
  }
  return counters;
}

}  // namespace haptiv
