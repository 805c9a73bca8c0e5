// The window while devices are listed on another thread, come and go, or do not answer.
#include <gmock/gmock.h>

#include <thread>

#include "app/window/session/SessionStatus.h"
#include "tests/app/window/devices/BusWindow.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::waitFor;

class WatchedDevices : public BusWindow {
 protected:
  void SetUp() override {
    Window::SetUp();
    window_->resize(1280, 760);
  }
  /// Has the devices listed; one does not answer: returns while it is being asked.
  void lookUntilItIsSilent() {
    emit find<QMenu>("deviceMenu").aboutToShow();
    while (!bus_.isAsked()) std::this_thread::yield();
  }
  QString told() { return find<SessionStatus>().currentMessage(); }
};

TEST_F(WatchedDevices, AreLookedForUntilTheyAreListed) {
  pictureOfMenu("deviceMenu", "device-menu-empty");
  plugBoard("B-0001").faults.silentControl = true;
  window_ = std::make_unique<MainWindow>();  // the event loop has not turned since
  window_->resize(1280, 760);
  for (const char* menu : {"deviceMenu", "handMenu"}) EXPECT_THAT(shown(menu), HasSubstr("Looking for devices..."));
  EXPECT_TRUE(find<QAction>("simDeviceAction").isEnabled()) << "what is known can be chosen";
  window_->show();
  pictureOfMenu("deviceMenu", "device-menu-looking");
  EXPECT_TRUE(isShownInTime("deviceMenu", "1-2 - does not answer"));
  EXPECT_TRUE(isShownInTime("handMenu", "None is plugged in"));
  EXPECT_THAT(shown("deviceMenu"), Not(HasSubstr("Looking")));
  EXPECT_EQ(told(), "") << "it has been there before";
}

TEST_F(WatchedDevices, ComeAndGoInAnOpenMenuAndAreTold) {
  listed("deviceMenu");
  auto& menu = find<QMenu>("deviceMenu");
  menu.popup(window_->mapToGlobal(QPoint(150, 120)));
  test::VirtualPort& port = plugBoard("B-0001");
  EXPECT_TRUE(isShownInTime("deviceMenu", "board B-0001 - not homed"));
  EXPECT_EQ(told(), "Plugged in: Haptiv interface board B-0001 - not homed");
  EXPECT_TRUE(menu.isVisible());
  picture("device-plugged-in");
  bus_.unplug(port);
  EXPECT_TRUE(waitFor([&] { return told() == "Unplugged: Haptiv interface board B-0001"; })) << told().toStdString();
  EXPECT_THAT(shown("deviceMenu"), Not(HasSubstr("B-0001")));
}

TEST_F(WatchedDevices, AreToldInAClosedMenuTooButNotWhatOnlyChangesItsState) {
  test::VirtualPort& port = plugBoard("B-0001");
  EXPECT_TRUE(waitFor([&] { return told().contains("B-0001"); }));
  find<SessionStatus>().clearMessage();
  port.faults.silentControl = true;
  EXPECT_THAT(listed("deviceMenu"), HasSubstr("B-0001 - does not answer"));
  EXPECT_EQ(told(), "");
}

TEST_F(WatchedDevices, TheChosenOneStaysChosenWhileItIsAway) {
  test::VirtualPort& port = plugBoard("B-0001");
  plugBoard("B-0002").faults.silentControl = true;
  plugBoard("B-0003");
  choose("deviceMenu", "usb:B-0001DeviceAction");
  pictureOfMenu("deviceMenu", "device-menu-boards");
  bus_.unplug(port);
  EXPECT_TRUE(isShownInTime("deviceMenu", "Haptiv interface board B-0001 - not plugged in"));
  EXPECT_TRUE(find<QAction>("usb:B-0001DeviceAction").isChecked());
  EXPECT_THAT(shown("deviceMenu"), AllOf(HasSubstr("does not answer"), HasSubstr("B-0003 - not homed")));
  pictureOfMenu("deviceMenu", "device-menu-away");
  plugBoard("B-0001");
  EXPECT_TRUE(isShownInTime("deviceMenu", "board B-0001 - not homed"));
  EXPECT_TRUE(find<QAction>("usb:B-0001DeviceAction").isChecked());
}

TEST_F(WatchedDevices, TheWindowClosesInTheMiddleOfAListing) {
  plugBoard("B-0001").faults.silentControl = true;
  lookUntilItIsSilent();
  window_.reset();
  EXPECT_FALSE(bus_.isAsked());
}

TEST_F(WatchedDevices, AreLeftAloneByASessionThatWasStartedInTheMiddleOfAListing) {
  test::VirtualPort& port = plugBoard("B-0001");
  port.faults.silentControl = true;
  openScene(kNoWalls);
  lookUntilItIsSilent();
  startSession();
  EXPECT_FALSE(bus_.isAsked());
  bus_.unplug(port);
  plugBoard("B-0002");
  QTest::qWait(300);
  EXPECT_THAT(shown("deviceMenu"), Not(HasSubstr("B-0002")));
  EXPECT_EQ(told(), "");
  stopSession();
  EXPECT_TRUE(isShownInTime("deviceMenu", "B-0002")) << "it is looked for when the session is over";
  EXPECT_EQ(told(), "Unplugged: Haptiv interface board B-0001; Plugged in: Haptiv interface board B-0002 - not homed");
}

}  // namespace
}  // namespace haptiv
