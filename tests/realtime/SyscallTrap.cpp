#include "tests/realtime/SyscallTrap.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace haptiv::testing {
namespace {

std::atomic<std::size_t> caught = 0;
std::atomic<int> last = 0;

#ifdef __x86_64__

void refuse(int, siginfo_t* information, void* context) {
  ++caught;
  last = information->si_syscall;
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RAX] = -ENOSYS;
}

constexpr sock_filter kLoadNumber = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
constexpr sock_filter kAllow = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);

/// Goes on with the next instruction where the call has this number, else over it.
constexpr sock_filter isCall(std::uint32_t number) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, number, 0, 1);
}

#endif

}  // namespace

std::string trapSyscalls() {
#ifdef __x86_64__
  struct sigaction action {};
  action.sa_sigaction = refuse;
  action.sa_flags = SA_SIGINFO;
  if (sigaction(SIGSYS, &action, nullptr) != 0) return std::strerror(errno);
  sock_filter filter[] = {
      kLoadNumber, isCall(__NR_clock_nanosleep), kAllow, isCall(__NR_clock_gettime),
      kAllow,      isCall(__NR_rt_sigreturn),    kAllow, isCall(__NR_exit),
      kAllow,      isCall(__NR_exit_group),      kAllow, BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP)};
  const sock_fprog program{sizeof filter / sizeof filter[0], filter};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
    return std::string("seccomp is not permitted here: ") + std::strerror(errno);
  return {};
#else
  return "system calls are trapped on x86-64 alone";
#endif
}

std::size_t caughtSyscalls() noexcept {
  return caught;
}

int lastCaughtSyscall() noexcept {
  return last;
}

}  // namespace haptiv::testing
