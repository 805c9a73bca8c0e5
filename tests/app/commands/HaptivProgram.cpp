#include "tests/app/commands/HaptivProgram.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string_view>
#include <thread>

extern char** environ;

namespace haptiv {
namespace {

constexpr std::chrono::seconds kPatience(60);

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environmentWithoutDisplay() {
  std::vector<std::string> variables;
  for (char** at = environ; *at; ++at) {
    const std::string_view variable = *at;
    if (variable.starts_with("DISPLAY=") || variable.starts_with("WAYLAND_DISPLAY=") || variable.starts_with("QT_"))
      continue;
    variables.emplace_back(variable);
  }
  return variables;
}

}  // namespace

HaptivProgram::HaptivProgram(const std::vector<std::string>& arguments, const std::string& stdoutPath) {
  std::vector<std::string> words = {HAPTIV_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environmentWithoutDisplay();
  const std::string out = stdoutPath.empty() ? folder_ / "out" : stdoutPath;
  const std::string err = folder_ / "err";

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&files, 2, err.c_str(), O_WRONLY | O_CREAT, 0600);
  const int error =
      posix_spawn(&process_, words[0].c_str(), &files, nullptr, pointersTo(words).data(), pointersTo(variables).data());
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error(words[0] + " cannot be started");
}

HaptivProgram::~HaptivProgram() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
}

void HaptivProgram::send(int signal) const {
  kill(process_, signal);
}

Ended HaptivProgram::wait() {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  int status = 0;
  while (waitpid(process_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) kill(process_, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readFile(folder_ / "out"),
          readFile(folder_ / "err")};
}

Ended runHaptiv(const std::vector<std::string>& arguments) {
  return HaptivProgram(arguments).wait();
}

}  // namespace haptiv
