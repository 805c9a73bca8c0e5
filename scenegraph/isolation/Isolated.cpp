#include "scenegraph/isolation/Isolated.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;

constexpr rlim_t kMemory = rlim_t{4} << 30;
#ifdef __SANITIZE_ADDRESS__
constexpr rlim_t kFiles = 64;  // the sanitizers ask pipes whether an address may be read
#else
constexpr rlim_t kFiles = 0;
#endif
constexpr std::size_t kMaxResult = std::size_t{1} << 30;

/// What child and parent share: what the child was doing last.
struct Note {
  int line;
  char doing[252];  // ends in 0, whatever is written before
};

/// Null in processes that are not isolated.
Note* note = nullptr;

void limit(__rlimit_resource what, rlim_t soft) {
  rlimit both{};
  if (::getrlimit(what, &both) != 0) return;
  both.rlim_cur = std::min(soft, both.rlim_max);
  ::setrlimit(what, &both);
}

/// Data and stack of this process [bytes].
rlim_t memoryInUse() {
  std::ifstream statm("/proc/self/statm");
  rlim_t pages = 0;
  for (int field = 0; field < 6; ++field) statm >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void writeAll(int to, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(to, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) ::_exit(2);
    done += static_cast<std::size_t>(count);
  }
}

/// The life of the child. The first byte of what it writes says whether the rest is the result (1) or a fault (0).
[[noreturn]] void live(int to, const std::function<std::string()>& work, std::chrono::seconds time) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT}) ::signal(signal, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int standard : {0, 1, 2}) ::dup2(nowhere, standard);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(time.count()));
  limit(RLIMIT_DATA, memoryInUse() + kMemory);
  limit(RLIMIT_NOFILE, kFiles);
  std::string answer;
  try {
    answer = "1" + work();
  } catch (const std::bad_alloc&) {
    answer = "0it takes too much memory";
  } catch (const std::exception& error) {
    answer = std::string("0") + error.what();
  }
  writeAll(to, answer);
  ::_exit(0);
}

/// Everything that the child writes, until it ends or its time is over.
std::string listen(int from, pid_t child, std::chrono::seconds time) {
  std::string answer;
  const auto deadline = Clock::now() + 2 * time;
  std::string piece(1 << 16, '\0');
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd ready{from, POLLIN, 0};
    const int count = left > 0 ? ::poll(&ready, 1, static_cast<int>(left)) : 0;
    if (count < 0 && errno == EINTR) continue;
    const ssize_t got = count > 0 ? ::read(from, piece.data(), piece.size()) : -1;
    if (got == 0) return answer;
    if (got < 0 || answer.size() > kMaxResult) {
      ::kill(child, SIGKILL);
      return {};
    }
    answer.append(piece, 0, static_cast<std::size_t>(got));
  }
}

Isolated faultOf(int status, const Note& last, std::chrono::seconds time) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const std::string how = signal == SIGKILL || signal == SIGXCPU
                              ? "takes longer than " + std::to_string(time.count()) + " s"
                              : std::string("crashes");
  return {{}, "Coin " + how + " while it " + last.doing + ": correct or simplify the scene there", last.line};
}

/// What is to be closed and unmapped in every case.
struct Shared {
  Shared() {
    void* page = ::mmap(nullptr, sizeof(Note), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page != MAP_FAILED) last = new (page) Note{};
    if (::pipe2(ends, O_CLOEXEC) != 0) ends[0] = ends[1] = -1;
  }
  ~Shared() {
    for (const int end : ends) {
      if (end >= 0) ::close(end);
    }
    if (last) ::munmap(last, sizeof(Note));
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  bool isWhole() const { return last && ends[0] >= 0; }

  Note* last = nullptr;
  int ends[2] = {-1, -1};
};

}  // namespace

void tellProgress(std::string_view doing, int line) {
  if (!note) return;
  const std::size_t size = std::min(doing.size(), sizeof(note->doing) - 1);
  std::memcpy(note->doing, doing.data(), size);
  note->doing[size] = 0;
  note->line = line;
}

void allowTime(std::chrono::seconds time) {
  rusage used{};
  if (!note || ::getrusage(RUSAGE_SELF, &used) != 0) return;
  limit(RLIMIT_CPU, static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + time.count()));
}

Isolated runIsolated(const std::function<std::string()>& work, std::chrono::seconds time) {
  if (note) return {work(), {}, 0};  // isolated already
  Shared shared;
  const pid_t child = shared.isWhole() ? ::fork() : -1;
  if (child < 0) return {{}, std::string("no process can be started to check it in: ") + std::strerror(errno), 0};
  if (child == 0) {
    note = shared.last;
    live(shared.ends[1], work, time);
  }
  ::close(shared.ends[1]);
  shared.ends[1] = -1;
  std::string answer = listen(shared.ends[0], child, time);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.empty()) return faultOf(status, *shared.last, time);
  const bool isResult = answer.front() == '1';
  answer.erase(0, 1);
  return isResult ? Isolated{std::move(answer), {}, 0} : Isolated{{}, std::move(answer), 0};
}

FilesAllowed::FilesAllowed() {
  if (note) limit(RLIMIT_NOFILE, RLIM_INFINITY);
}

FilesAllowed::~FilesAllowed() {
  if (note) limit(RLIMIT_NOFILE, kFiles);
}

}  // namespace haptiv
