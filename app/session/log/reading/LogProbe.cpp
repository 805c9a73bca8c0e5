#include "app/session/log/reading/LogProbe.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <string>

namespace haptiv {
namespace {

enum ChildExit { kSound = 0, kTrouble = 1 };

/// In the child: dies after `patience`, whatever happens; never returns.
[[noreturn]] void readAndExit(const std::function<void()>& read, std::chrono::seconds patience, int report) {
  std::signal(SIGALRM, SIG_DFL);
  sigset_t alarmOnly;
  sigemptyset(&alarmOnly);
  sigaddset(&alarmOnly, SIGALRM);
  sigprocmask(SIG_UNBLOCK, &alarmOnly, nullptr);
  alarm(static_cast<unsigned>(patience.count()));
  for (int crash : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) std::signal(crash, SIG_DFL);
  try {
    read();
  } catch (const std::exception& error) {
    const std::string words = error.what();
    const ssize_t written = write(report, words.data(), words.size());
    _exit(written < 0 ? kSound + 2 : kTrouble);
  } catch (...) {
    _exit(kSound + 2);
  }
  _exit(kSound);
}

/// All that comes from `report` until its other end is closed.
std::string readAll(int report) {
  std::string words;
  std::array<char, 1024> block;
  for (;;) {
    const ssize_t count = read(report, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return words;
    words.append(block.data(), static_cast<std::size_t>(count));
  }
}

int waitFor(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

void probeInChild(const std::filesystem::path& file, const std::function<void()>& read, std::chrono::seconds patience) {
  constexpr const char* kNoChild =
      ": cannot probe the file in a process of its own. Close other programs and try again";
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(file.string() + kNoChild);
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    readAndExit(read, patience, ends[1]);
  }
  close(ends[1]);
  const std::string words = child > 0 ? readAll(ends[0]) : std::string();
  close(ends[0]);
  if (child < 0) throw std::runtime_error(file.string() + kNoChild);
  const int status = waitFor(child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kSound) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kTrouble) throw std::runtime_error(words);
  const bool hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  throw std::runtime_error(file.string() + ": damaged so that reading it " +
                           (hung ? "did not end" : "crashed the HDF5 library") + ". Use another copy of it");
}

}  // namespace haptiv
