/// The servo loop as it runs, with every door to the system watched.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <set>

#include "tests/realtime/GuardedDevice.h"
#include "tests/realtime/ServoRun.h"

namespace haptiv {
namespace {

using testing::GuardedDevice;
using testing::runServo;

/// The arm, and what must not be done in a read.
class WaywardArm : public HapticDevice {
 public:
  WaywardArm(HapticDevice& device, std::function<void()> slip) : device_(device), slip_(std::move(slip)) {}
  void start(double period) override { device_.start(period); }
  void stop() override { device_.stop(); }
  void write(const DeviceCommand& command) noexcept override { device_.write(command); }
  DeviceReading read() noexcept override {
    slip_();
    return device_.read();
  }

 private:
  HapticDevice& device_;
  std::function<void()> slip_;
};

class ServoGuard : public ::testing::TestWithParam<const char*> {
 protected:
  std::vector<TickRecord> run(
      std::uint64_t ticks, std::function<void()> slip = [] {}) {
    WaywardArm wayward(arm, std::move(slip));
    GuardedDevice guarded(wayward);
    const std::vector<TickRecord> records = runServo(guarded, description, ticks);
    calls = guarded.calls;
    syscalls = guarded.syscalls;
    lastSyscall = guarded.lastSyscall;
    whyNoTrap = guarded.whyNoTrap;
    return records;
  }

  DeviceDescription description = loadDeviceDescription(GetParam());
  SimulatedDevice arm = testing::pulledArm(description);
  testing::HiddenCalls calls;
  std::size_t syscalls = 0;
  int lastSyscall = -1;
  std::string whyNoTrap;
};
INSTANTIATE_TEST_SUITE_P(BuiltIn, ServoGuard, ::testing::Values("vishard10", "anthropomorphic7", "falcon"));

TEST_P(ServoGuard, SeesNoAllocationLockOrSystemCallInASecondOfTheServo) {
  const std::vector<TickRecord> records = run(1000);
  EXPECT_EQ(calls.heap, 0u);
  EXPECT_EQ(calls.locks, 0u);
  EXPECT_EQ(syscalls, 0u) << "the last one was number " << lastSyscall;
  // It was not idle.
  std::set<std::uint32_t> versions;
  for (const TickRecord& record : records) versions.insert(record.sceneVersion);
  EXPECT_GT(versions.size(), 2u);
  EXPECT_TRUE(std::ranges::any_of(records, [](const TickRecord& record) { return record.contacts > 0; }));
  EXPECT_TRUE(std::ranges::any_of(records, [](const TickRecord& record) { return record.zones > 0; }));
  if (!whyNoTrap.empty()) GTEST_SKIP() << "allocations and locks were watched, system calls not: " << whyNoTrap;
}

TEST_P(ServoGuard, SeesAHiddenAllocation) {
  const std::size_t ticks = run(20, [] { std::free(std::malloc(16)); }).size();
  EXPECT_EQ(calls.heap, 2 * (ticks - 1));  // the last read is not followed by another one that would tell
}

TEST_P(ServoGuard, SeesAHiddenLock) {
  std::mutex mutex;
  const std::size_t ticks = run(20, [&] { const std::lock_guard lock(mutex); }).size();
  EXPECT_EQ(calls.locks, ticks - 1);
}

TEST_P(ServoGuard, SeesAHiddenSystemCall) {
  const std::size_t ticks = run(20, [] { ::syscall(SYS_getppid); }).size();
  if (!whyNoTrap.empty()) GTEST_SKIP() << whyNoTrap;
  EXPECT_EQ(syscalls, ticks - 1);
  EXPECT_EQ(lastSyscall, SYS_getppid);
}

}  // namespace
}  // namespace haptiv
