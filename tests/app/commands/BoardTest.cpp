/// `haptiv board`, run as a user runs it.
#include <gmock/gmock.h>

#include <csignal>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;

}  // namespace

TEST(Board, SaysWhereItIsAndHowToPlugItIn) {
  const Ended ended = runHaptiv({"board", "--port", "0", "--seconds", "0.3", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_GT(ended.json()["port"].get<int>(), 0);
  EXPECT_EQ(ended.json()["address"], "127.0.0.1");
  EXPECT_THAT(ended.err, HasSubstr("attach -r localhost -b 1-1"));
  if (!ended.json()["kernel_ready"].get<bool>()) {
    EXPECT_THAT(ended.err, HasSubstr("modprobe vhci-hcd"));
  }
}

TEST(Board, EndsWhenItIsTold) {
  HaptivProgram program({"board", "--port", "0"});
  for (int i = 0; i < 100; ++i) program.send(0);  // it is there
  program.send(SIGTERM);
  const Ended ended = program.wait();
  EXPECT_TRUE(ended.code == 0 || ended.code == 128 + SIGTERM) << ended.code;  // the latter: before it held the signal
}

TEST(Board, NamesAnAddressThatIsNone) {
  const Ended ended = runHaptiv({"board", "--bind", "nowhere", "--seconds", "1"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("no IPv4 address"));
  EXPECT_EQ(runHaptiv({"board", "--port", "70000"}).code, 2);
  EXPECT_EQ(runHaptiv({"board", "--serial", "a b", "--port", "0", "--seconds", "1"}).code, 3);
}

}  // namespace haptiv
