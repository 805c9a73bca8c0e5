// `haptiv run` with a Falcon, and with a SpaceMouse of several.
#include "tests/app/commands/devices/BusCommands.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kFalconScene = HAPTIV_SOURCE_DIR "/scenes/falcon-wall.iv";
const std::string kScene = HAPTIV_SOURCE_DIR "/scenes/wall.iv";

class RunWithDevice : public BusCommands {};

TEST_F(RunWithDevice, OneOfTwoFalconsIsChosenByItsPort) {
  plugFalcon();
  plugFalcon();
  const test::RunningBus runs(bus_);
  const std::vector<std::string> scene = {"run", kFalconScene, "--firmware", firmware(), "--seconds", "0.3", "--json"};
  const auto with = [&](const std::string& device) {
    std::vector<std::string> arguments = scene;
    arguments.insert(arguments.end(), {"--device", device});
    return arguments;
  };
  EXPECT_EQ(run(with("falcon")), 3);
  EXPECT_THAT(err_, AllOf(HasSubstr("several"), HasSubstr("1-2, 1-3")));
  EXPECT_EQ(run(with("falcon:1-9")), 3);
  EXPECT_THAT(err_, HasSubstr("there is: 1-2, 1-3"));
  EXPECT_EQ(run(with("falcon:")), 2);
  EXPECT_THAT(err_, HasSubstr("haptiv device list"));
  ASSERT_EQ(run(with("falcon:1-3")), 0) << err_;
  EXPECT_GT(json()["ticks"].get<int>(), 100);
  EXPECT_GT(falcon_->falcon.orders(), 100u) << "it was the other one";
}

TEST_F(RunWithDevice, OneOfTwoSpaceMiceIsTheHand) {
  plugMouse();
  plugMouse();
  for (const std::string hand : {"spacemouse", "spacemouse:position"}) {
    EXPECT_EQ(run({"run", kScene, "--hand", hand, "--seconds", "0.2"}), 3) << hand;
    EXPECT_THAT(err_, HasSubstr("1-2, 1-3")) << hand;
    EXPECT_EQ(run({"run", kScene, "--hand", hand + ":", "--seconds", "0.2"}), 2) << hand;
    EXPECT_EQ(run({"run", kScene, "--hand", hand + ":1-3", "--seconds", "0.2"}), 0) << hand << err_;
  }
}

TEST_F(RunWithDevice, ABoardThatIsNotHomedSaysHow) {
  plugBoard("B-0001");
  EXPECT_EQ(run({"run", kScene, "--device", "usb", "--seconds", "0.2"}), 3);
  EXPECT_THAT(err_, HasSubstr("haptiv device home"));
}

}  // namespace
}  // namespace haptiv
