#include "app/board/VhciHint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace haptiv {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A machine whose /sys and /lib/modules are in a folder of its own.
struct Machine : testing::Test {
  Machine() { fs::create_directories(root / "lib/modules/6.1"); }
  ~Machine() override { fs::remove_all(root); }
  VhciHint hint(int port = 3240) const { return vhciHint(root, "6.1", "127.0.0.1", port); }

  fs::path root = fs::temp_directory_path() / ("haptiv-vhci-" + std::to_string(::getpid()));
};

TEST_F(Machine, WithTheControllerIsReady) {
  fs::create_directories(root / "sys/devices/platform/vhci_hcd.0");
  EXPECT_TRUE(hint().ready);
  EXPECT_THAT(hint().advice, HasSubstr("usbip attach -r localhost -b 1-1"));
  EXPECT_THAT(hint().advice, Not(HasSubstr("modprobe")));
  EXPECT_THAT(hint(4000).advice, HasSubstr("usbip --tcp-port 4000 attach"));
}

TEST_F(Machine, WithTheModuleIsToldToLoadIt) {
  std::ofstream(root / "lib/modules/6.1/modules.dep")
      << "kernel/drivers/usb/usbip/usbip-core.ko:\nkernel/drivers/usb/usbip/vhci-hcd.ko.xz: kernel/x.ko\n";
  EXPECT_FALSE(hint().ready);
  EXPECT_THAT(hint().advice, HasSubstr("sudo modprobe vhci-hcd"));
}

TEST_F(Machine, WithoutIsToldWhatIsMissing) {
  std::ofstream(root / "lib/modules/6.1/modules.dep") << "kernel/x.ko: kernel/vhci-hcd.ko\n";
  EXPECT_FALSE(hint().ready);
  EXPECT_THAT(hint().advice, HasSubstr("kernel (6.1) has no virtual host controller"));
  EXPECT_THAT(hint().advice, HasSubstr("CONFIG_USBIP_VHCI_HCD"));
}

}  // namespace
}  // namespace haptiv
