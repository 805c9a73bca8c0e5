#include "app/calibration/LoadsFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace haptiv {
namespace {

using testing::HasSubstr;

struct Loads : testing::Test {
  ~Loads() override { std::filesystem::remove(path); }
  std::vector<KnownLoad> read(const std::string& text) {
    std::ofstream(path) << text;
    return readLoadsFile(path);
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "it was not refused";
  }
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("haptiv-loads-" + std::to_string(::getpid()) + ".csv");
};

TEST_F(Loads, AreForceAndTorqueALine) {
  const auto loads = read("fx,fy,fz,tx,ty,tz\n\n10,0,-2.5, 0,0,0.4\n0,0,0,1,2,3\r\n");
  ASSERT_EQ(loads.size(), 2u);
  EXPECT_EQ(loads[0].load, (Vector6() << 10, 0, -2.5, 0, 0, 0.4).finished());
  EXPECT_FALSE(loads[0].counts);
}

TEST_F(Loads, AreWrittenSoThatTheyReadTheSame) {
  const std::vector<Vector6> loads = {(Vector6() << 0.1, -9.80665, 1. / 3, 0, -0.4, 1e-7).finished(), Vector6::Ones()};
  const auto back = read(loadsText(loads));
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(back[i].load, loads[i]);
}

TEST_F(Loads, MayHaveTheSensorsCountsBesideThem) {
  const auto loads = read("fx,fy,fz,tx,ty,tz,c1,c2,c3,c4,c5,c6\n1,0,0,0,0,0,50.5,0,0,0,0,-1\n");
  ASSERT_TRUE(loads.at(0).counts);
  EXPECT_EQ((*loads[0].counts)[0], 50.5);
  EXPECT_EQ((*loads[0].counts)[5], -1);
}

TEST_F(Loads, AreRefusedWithTheirLine) {
  EXPECT_THAT(refusal("fx,fy\n"), HasSubstr(".csv:1: the columns are"));
  EXPECT_THAT(refusal("fx,fy,fz,tx,ty,tz,c1\n"), HasSubstr(":1: "));
  EXPECT_THAT(refusal("fx,fy,fz,tx,ty,tz\n1,2,3\n"), HasSubstr(":2: the line has 3 cells"));
  EXPECT_THAT(refusal("fx,fy,fz,tx,ty,tz\n1,2,3,4,5,6,7\n"), HasSubstr(":2: the line has 7 cells"));
  EXPECT_THAT(refusal("fx,fy,fz,tx,ty,tz\n1,2,3,4,5,heavy\n"), HasSubstr(":2: tz is \"heavy\""));
  EXPECT_THAT(refusal("fx,fy,fz,tx,ty,tz\n1,2,nan,4,5,6\n"), HasSubstr("no finite number"));
  EXPECT_THAT(refusal("fx,fy,fz,tx,ty,tz\n" + std::string(5000, '1') + "\n"), HasSubstr("longer than 1000"));
  EXPECT_THAT(refusal(""), HasSubstr("no load in it"));
  EXPECT_THAT(refusal("fx,fy,fz,tx,ty,tz\n"), HasSubstr("no load in it"));
}

}  // namespace
}  // namespace haptiv
