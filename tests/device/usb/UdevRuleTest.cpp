/// The udev rule that messages tell users to install lets them open every device that the program looks for.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <regex>

#include "device/usb/falcon/FalconPort.h"
#include "device/usb/host/BoardRequests.h"
#include "device/usb/spacemouse/SpaceMouseModels.h"

namespace haptiv::usb {
namespace {

struct Rule {
  std::string vendor, product;  // patterns; an empty product: any
};

std::vector<Rule> rules() {
  std::ifstream file(HAPTIV_SOURCE_DIR "/device/usb/60-haptiv.rules");
  const std::regex vendor(R"re(ATTR\{idVendor\}=="([^"]*)")re"), product(R"re(ATTR\{idProduct\}=="([^"]*)")re");
  std::vector<Rule> all;
  for (std::string line; std::getline(file, line);) {
    std::smatch found;
    if (line.starts_with('#') || !std::regex_search(line, found, vendor)) continue;
    EXPECT_NE(line.find("TAG+=\"uaccess\""), std::string::npos) << line;
    EXPECT_NE(line.find("GROUP=\"plugdev\""), std::string::npos) << line;
    all.push_back({found[1], std::regex_search(line, found, product) ? found[1].str() : "*"});
  }
  return all;
}

std::string hex(std::uint16_t number) {
  char text[5];
  std::snprintf(text, sizeof text, "%04x", number);
  return text;
}

bool isPermitted(const UsbId& id) {
  for (const Rule& rule : rules())
    if (fnmatch(rule.vendor.c_str(), hex(id.vendor).c_str(), 0) == 0 &&
        fnmatch(rule.product.c_str(), hex(id.product).c_str(), 0) == 0)
      return true;
  return false;
}

TEST(UdevRule, CoversBoardsFalconsAndAllSpaceMice) {
  for (const UsbKind& kind : {boardKind(), falcon::usbKind(), spaceMouseKind()})
    for (const UsbId& id : kind.ids) EXPECT_TRUE(isPermitted(id)) << kind.name << ' ' << hex(id.product);
}

TEST(UdevRule, OpensNoOtherDevice) {
  EXPECT_FALSE(isPermitted({0x0403, 0x6001})) << "any serial cable of the Falcon's chip";
  EXPECT_FALSE(isPermitted({0x046d, 0xc077})) << "a mouse of Logitech's";
}

}  // namespace
}  // namespace haptiv::usb
