#pragma once

#include <QAction>
#include <QMenu>
#include <memory>
#include <string>

#include "app/window/operator/DeviceWatch.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/device/usb/falcon/BenchedFalcon.h"
#include "tests/device/usb/spacemouse/VirtualSpaceMouse.h"
#include "tests/support/usb/RunningBus.h"

namespace haptiv {

/// The window on a machine with a virtual USB bus below real libusb.
class BusWindow : public Window {
 protected:
  BusWindow() {
    for (const char* name : {"HAPTIV_FALCON_FIRMWARE", "XDG_DATA_HOME"}) qunsetenv(name);
  }
  ~BusWindow() override { window_.reset(); }  // before the bus below it

  std::shared_ptr<test::VirtualSpaceMouse> plugMouse() {
    auto mouse = std::make_shared<test::VirtualSpaceMouse>();
    mousePort_ = &bus_.plug(mouse);
    return mouse;
  }
  test::VirtualPort& plugBoard(const std::string& serial) {
    return bus_.plug(std::make_shared<test::BoardOnUsb>(loadDeviceDescription("vishard10"), serial));
  }
  void plugFalcon() {
    usb_ = std::make_shared<falcon::test::FalconOnUsb>(loadDeviceDescription("falcon"));
    falconPort_ = &bus_.plug(usb_);
  }
  falcon::test::VirtualFalcon& falcon() { return usb_->falcon; }

  /// What stands in a menu when it has been opened and all has been listed, a line each.
  std::string listed(const char* menu) {
    emit find<QMenu>(menu).aboutToShow();
    EXPECT_TRUE(testing::waitFor([&] { return find<DeviceWatch>().known().has_value(); }));
    do bus_.settle();
    while (bus_.isAsked());  // it lists no more; without a session
    QCoreApplication::processEvents();
    return shown(menu);
  }
  /// What stands there now.
  std::string shown(const char* menu) {
    QString all;
    for (const QAction* item : find<QMenu>(menu).actions()) all += item->text() + "\n";
    return all.toStdString();
  }
  bool isShownInTime(const char* menu, const char* text) {
    return testing::waitFor([&] { return shown(menu).find(text) != std::string::npos; });
  }
  /// For people to look at.
  void pictureOfMenu(const char* menu, const char* name) {
    find<QMenu>(menu).popup(window_->mapToGlobal(QPoint(150, 120)));
    picture(name);
    find<QMenu>(menu).close();
  }
  /// Opens a menu and takes this item.
  void choose(const char* menu, const char* item) {
    listed(menu);
    find<QAction>(item).trigger();
  }

  test::VirtualBus bus_;
  std::shared_ptr<falcon::test::FalconOnUsb> usb_;
  test::VirtualPort *mousePort_ = nullptr, *falconPort_ = nullptr;
};

}  // namespace haptiv
