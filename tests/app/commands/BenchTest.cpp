#include <gmock/gmock.h>

#include "tests/app/commands/HaptivProgram.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

TEST(Bench, GivesEveryResultWithTheSameKeys) {
  const Ended ended = runHaptiv({"bench", "tick", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json results = ended.json()["results"];
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0]["name"], "tick/maze");
  EXPECT_EQ(results[0]["n"], 10000);
  EXPECT_GT(results[0]["median_ns"], 0);
  EXPECT_GE(results[0]["p99_ns"], results[0]["median_ns"]);
  EXPECT_TRUE(results[0]["peer_median_ns"].is_null());
  EXPECT_THAT(ended.err, HasSubstr("bench: tick"));
}

TEST(Bench, SaysWhatThereIsWhereANameIsUnknown) {
  const Ended ended = runHaptiv({"bench", "tick,tock", "--json"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, HasSubstr("\"tock\""));
  EXPECT_THAT(ended.err, HasSubstr("collision, ik, compile, edits, log"));
}

}  // namespace
}  // namespace haptiv
