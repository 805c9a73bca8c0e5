#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "app/bench/measuring/BareTimer.h"
#include "app/bench/measuring/ThreadCounters.h"

namespace haptiv {
namespace {

TEST(ThreadCounters, CountThePagesThatAThreadTouchesFirst) {
  constexpr std::size_t kPages = 64;
  const auto page = static_cast<std::size_t>(getpagesize());
  const auto before = countersOf(gettid());
  ASSERT_TRUE(before);
  void* fresh = mmap(nullptr, kPages * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(fresh, MAP_FAILED);
  madvise(fresh, kPages * page, MADV_NOHUGEPAGE);  // or one fault would bring many pages
  for (std::size_t i = 0; i < kPages; ++i) static_cast<volatile char*>(fresh)[i * page] = 1;
  const auto after = countersOf(gettid());
  munmap(fresh, kPages * page);
  ASSERT_TRUE(after);
  EXPECT_GE(after->pageFaults, before->pageFaults + kPages / 16);  // Linux brings some around each
  EXPECT_GE(after->interruptions, before->interruptions);
}

TEST(ThreadCounters, AreNoneOfAThreadThatIsNoMore) {
  pid_t gone = 0;
  std::thread([&] { gone = gettid(); }).join();
  EXPECT_FALSE(countersOf(gone));
}

TEST(BareTimer, IsNeverAheadOfItsDeadlines) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const BareTimer timer(ServoPace{});
  while (timer.ticks() < 20) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::uint64_t missed = timer.missed(), ticks = timer.ticks();
  EXPECT_LE(missed, timer.ticks());
  EXPECT_LE(ticks, static_cast<std::uint64_t>((Clock::now() - begin) / std::chrono::milliseconds(1)) + 2);
}

}  // namespace
}  // namespace haptiv
