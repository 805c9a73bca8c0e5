#include "app/session/hands/HandFile.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace haptiv::testing;

class HandFile : public ::testing::Test {
 protected:
  std::vector<HandWaypoint> read(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return readHandFile(path_);
  }
  std::string trouble(const std::string& text) {
    return messageOf([&] { read(text); });
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "hand.csv";
};

TEST_F(HandFile, GivesTimesAndPlaces) {
  const std::vector<HandWaypoint> hand = read("t,x,y,z\n0,0.1,-0.2,3e-2\n1.5,1,2,3");
  ASSERT_EQ(hand.size(), 2u);
  EXPECT_EQ(hand[0].time, 0);
  EXPECT_EQ(hand[0].position, Vector3(0.1, -0.2, 0.03));
  EXPECT_EQ(hand[1].time, 1.5);
  EXPECT_EQ(hand[1].position, Vector3(1, 2, 3));
}

TEST_F(HandFile, PressesButtonsByColumnsOfTheirOwn) {
  EXPECT_EQ(read("t,x,y,z\n0,1,2,3\n").front().inputs, kInputDeadMan);
  const std::vector<HandWaypoint> hand =
      read("t,x,y,z,estop,deadman,reset\n0,1,2,3,0,1,0\n1,1,2,3,1,0,0\n2,1,2,3,0,0,1\n");
  EXPECT_EQ(hand[0].inputs, kInputDeadMan);
  EXPECT_EQ(hand[1].inputs, kInputEmergencyStop1);
  EXPECT_EQ(hand[2].inputs, kInputReset);
  EXPECT_EQ(read("t,x,y,z,estop\n0,1,2,3,1\n").front().inputs, kInputDeadMan | kInputEmergencyStop1);
}

TEST_F(HandFile, TellsButtonsThatAreNone) {
  EXPECT_THAT(trouble("t,x,y,z,pedal\n0,1,2,3,1\n"), AllOf(HasSubstr("hand.csv:1: "), HasSubstr("deadman")));
  EXPECT_THAT(trouble("t,x,y,z,reset,reset\n0,1,2,3,1,1\n"), HasSubstr("hand.csv:1: "));
  EXPECT_THAT(trouble("t,x,y,z,reset\n0,1,2,3,2\n"), AllOf(HasSubstr("hand.csv:2: "), HasSubstr("reset is \"2\"")));
  EXPECT_THAT(trouble("t,x,y,z,reset\n0,1,2,3\n"), AllOf(HasSubstr("hand.csv:2: "), HasSubstr("only 4 cells")));
}

TEST_F(HandFile, ToleratesWhatSpreadsheetsAndPeopleAdd) {
  EXPECT_EQ(read("\xEF\xBB\xBF# recorded by hand\r\n t , x,y,z\r\n\r\n0, 1 ,2,3\r\n# half way\r\n1,1,2,3\r\n").size(),
            2u);
}

TEST_F(HandFile, TellsMissingAndExtraColumns) {
  EXPECT_THAT(trouble("t,x,y\n0,1,2\n"), AllOf(HasSubstr("hand.csv:1: "), HasSubstr("t,x,y,z")));
  EXPECT_THAT(trouble("t;x;y;z\n0;1;2;3\n"), HasSubstr("hand.csv:1: "));
  EXPECT_THAT(trouble("0,1,2,3\n1,1,2,3\n"), HasSubstr("hand.csv:1: "));
  EXPECT_THAT(trouble("t,x,y,z\n0,1,2,3\n1,1,2\n"), AllOf(HasSubstr("hand.csv:3: "), HasSubstr("only 3 cells")));
  EXPECT_THAT(trouble("t,x,y,z\n0,1,2,3,4\n"), AllOf(HasSubstr("hand.csv:2: "), HasSubstr("more than 4 cells")));
}

TEST_F(HandFile, TellsCellsThatAreNoNumbers) {
  EXPECT_THAT(trouble("t,x,y,z\n0,1,,3\n"), AllOf(HasSubstr("hand.csv:2: "), HasSubstr("y is empty")));
  EXPECT_THAT(trouble("t,x,y,z\n0,1,2,nan\n"), AllOf(HasSubstr("hand.csv:2: "), HasSubstr("z is \"nan\"")));
  EXPECT_THAT(trouble("t,x,y,z\n0,inf,2,3\n"), HasSubstr("x is \"inf\""));
  EXPECT_THAT(trouble("t,x,y,z\n0,1e999,2,3\n"), HasSubstr("no finite number"));
  EXPECT_THAT(trouble("t,x,y,z\n0,1m,2,3\n"), HasSubstr("x is \"1m\""));
}

TEST_F(HandFile, TellsTimesThatDoNotRise) {
  EXPECT_THAT(trouble("t,x,y,z\n0,1,2,3\n1,1,2,3\n# here\n0.5,1,2,3\n"),
              AllOf(HasSubstr("hand.csv:5: "), HasSubstr("times rise")));
  EXPECT_THAT(trouble("t,x,y,z\n0,1,2,3\n0,1,2,3\n"), HasSubstr("hand.csv:3: "));
}

TEST_F(HandFile, TellsAHoleInARecording) {
  std::string text = "t,x,y,z\n";
  for (int i = 0; i < 100; ++i)
    if (i < 50 || i >= 65) text += std::to_string(i * 0.01) + ",0,0,0\n";
  EXPECT_THAT(trouble(text), AllOf(HasSubstr("hand.csv:52: "), HasSubstr("a hole from 0.49 s to 0.65 s")));
}

TEST_F(HandFile, TakesNoHoleForOneInWaypointsByHand) {
  EXPECT_EQ(read("t,x,y,z\n0,0,0,0\n0.1,0,0,0\n0.2,0,0,0\n30,0,0,0\n").size(), 4u);
}

TEST_F(HandFile, TellsFilesWithoutWaypoints) {
  EXPECT_THAT(trouble(""), AllOf(HasSubstr("hand.csv:1: "), HasSubstr("empty")));
  EXPECT_THAT(trouble("t,x,y,z\n"), HasSubstr("no waypoint"));
  EXPECT_THAT(messageOf([&] { readHandFile(folder_ / "none.csv"); }), HasSubstr("none.csv: there is no such"));
}

}  // namespace
}  // namespace haptiv
