// `haptiv device list` with something plugged in.
#include "tests/app/commands/devices/BusCommands.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class DeviceList : public BusCommands {};

TEST_F(DeviceList, IsOneTableOfAllKinds) {
  plugBoard("B-0001");
  plugFalcon();
  plugMouse();
  ASSERT_EQ(run({"device", "list", "--firmware", firmware()}), 0) << err_;
  EXPECT_THAT(out_, AllOf(ContainsRegex("usb:B-0001 +Haptiv interface board +B-0001 +1-2 +not homed\n"),
                          ContainsRegex("falcon:FALCON-1 +FALCON HAPTIC +FALCON-1 +1-3 +usable\n"),
                          ContainsRegex("spacemouse:1-4 +SpaceNavigator +- +1-4 +usable\n")));
  EXPECT_THAT(out_, Not(HasSubstr("is plugged in")));
}

TEST_F(DeviceList, SaysWhatToDoWhereOneCannotBeUsed) {
  plugFalcon();
  plugMouse().permitted = false;
  ASSERT_EQ(run({"device", "list"}), 0) << err_;
  EXPECT_THAT(out_, AllOf(HasSubstr("firmware missing\n"), HasSubstr(folder_ / "data/haptiv/falcon.bin"),
                          HasSubstr("no permission\n"), HasSubstr("sudo cp device/usb/60-haptiv.rules")));
}

TEST_F(DeviceList, SaysWhichOfTheBoardsDoesNotAnswer) {
  plugBoard("B-0001").faults.silentControl = true;
  plugBoard("B-0002");
  ASSERT_EQ(run({"device", "list"}), 0) << err_;
  EXPECT_THAT(out_, AllOf(ContainsRegex("usb:1-2 +interface board +- +1-2 +does not answer\n.*switch it off and on\n"),
                          ContainsRegex("usb:B-0002 +Haptiv interface board +B-0002 +1-3 +not homed\n")));
}

TEST_F(DeviceList, TellsProgramsTheSame) {
  plugBoard("B-0001");
  plugMouse();
  ASSERT_EQ(run({"device", "list", "--json"}), 0) << err_;
  const auto list = json();
  EXPECT_EQ(list["usb"][0]["serial"], "B-0001");
  EXPECT_EQ(list["usb"][0]["state"], "not homed");
  EXPECT_EQ(list["falcon"], nlohmann::json::array());
  EXPECT_EQ(list["spacemouse"][0]["name"], "spacemouse:1-3");
  EXPECT_EQ(list["spacemouse"][0]["port"], "1-3");
  EXPECT_EQ(list["spacemouse"][0]["trouble"], "");
}

TEST_F(DeviceList, NamesAreWhatTheOtherCommandsTake) {
  plugBoard("B-0001");
  plugBoard("B-0001");
  const test::RunningBus runs(bus_, std::chrono::microseconds(125));
  ASSERT_EQ(run({"device", "list", "--json"}), 0) << err_;
  const std::string name = json()["usb"][1]["name"];
  EXPECT_EQ(name, "usb:1-3") << "two with one serial number";
  EXPECT_EQ(run({"device", "monitor", "--device", "usb", "--seconds", "0.1"}), 3);
  EXPECT_THAT(err_, HasSubstr("1-2, 1-3"));
  ASSERT_EQ(run({"device", "monitor", "--device", name, "--seconds", "0.2", "--json"}), 0) << err_;
  EXPECT_GT(json()["states"].get<int>(), 0);
}

}  // namespace
}  // namespace haptiv
