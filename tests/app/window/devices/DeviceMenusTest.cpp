// What the window's menus show of the devices that are plugged in, as they come and go.
#include <gmock/gmock.h>

#include <QLabel>
#include <QMessageBox>

#include "tests/app/window/devices/BusWindow.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::waitFor;

class DeviceMenus : public BusWindow {};

TEST_F(DeviceMenus, ShowEachKindAndItsState) {
  EXPECT_THAT(listed("deviceMenu"), HasSubstr("None is plugged in"));
  plugBoard("B-0001");
  plugFalcon();
  plugMouse();
  EXPECT_THAT(listed("deviceMenu"), AllOf(HasSubstr("Haptiv interface board B-0001 - not homed"),
                                          HasSubstr("FALCON HAPTIC FALCON-1 - firmware missing"),
                                          HasSubstr("SpaceNavigator 1-4\n"), Not(HasSubstr("None is plugged in"))));
  pictureOfMenu("deviceMenu", "device-menu");
  pictureOfMenu("handMenu", "hand-menu");
  EXPECT_TRUE(find<QAction>("falcon:FALCON-1DeviceAction").toolTip().contains("--firmware"));
  falconPort_->permitted = false;
  EXPECT_THAT(listed("deviceMenu"), HasSubstr("Novint Falcon 1-3 - no permission"));
}

TEST_F(DeviceMenus, KeepWhatIsChosenWhenItHasGone) {
  plugFalcon();
  choose("deviceMenu", "falcon:FALCON-1DeviceAction");
  bus_.unplug(*falconPort_);
  EXPECT_THAT(listed("deviceMenu"), HasSubstr("FALCON-1 - not plugged in"));
  EXPECT_TRUE(find<QAction>("falcon:FALCON-1DeviceAction").isChecked());
  plugFalcon();
  EXPECT_THAT(listed("deviceMenu"), Not(HasSubstr("not plugged in")));
  EXPECT_TRUE(find<QAction>("falcon:FALCON-1DeviceAction").isChecked());
}

TEST_F(DeviceMenus, OneOfTwoSpaceMiceIsTheHand) {
  const auto first = plugMouse(), second = plugMouse();
  openScene(kNoWalls);
  choose("handMenu", "spaceMouse:1-3Action");
  EXPECT_TRUE(find<QAction>("spaceMouseVelocityAction").isChecked()) << "who chooses one wants to use it";
  const test::RunningBus runs(bus_);
  startSession();
  const QLabel& state = find<QLabel>("modeLabel");
  EXPECT_TRUE(waitFor([&] { return state.text() == "Ready"; }));
  EXPECT_TRUE(find<QLabel>("hintLabel").text().contains("SpaceMouse"));
  first->reports.push_back({3, 1});
  QTest::qWait(300);
  EXPECT_EQ(state.text(), "Ready") << "the other one is nobody's hand";
  second->reports.push_back({3, 1});
  EXPECT_TRUE(waitFor([&] { return state.text() == "Running"; }));
  stopSession();
}

TEST_F(DeviceMenus, OfTwoSpaceMiceOneHasToBeChosen) {
  plugMouse();
  plugMouse();
  choose("handMenu", "spaceMousePositionAction");
  clickButton("startAction");
  auto& box = find<QMessageBox>("messageBox");
  EXPECT_TRUE(box.text().contains("1-2, 1-3")) << box.text().toStdString();
  picture("two-spacemice");
  box.accept();
}

}  // namespace
}  // namespace haptiv
