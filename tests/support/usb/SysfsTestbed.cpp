#include "tests/support/usb/SysfsTestbed.h"

#include <umockdev.h>

#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace haptiv::test {

namespace {

std::string number(const char* format, int value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string pathOf(int address) {
  return "/devices/pci0000:00/usb1" + (address == 1 ? "" : "/1-" + std::to_string(address));
}

std::string hex(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += number("%02X", byte);
  return text;
}

/// As `umockdev-record` would write it.
std::string recordOf(const usb::Descriptors& device, int address) {
  const std::string node = "bus/usb/001/" + number("%03d", address);
  std::ostringstream text;
  text << "P: " << pathOf(address) << "\nN: " << node << "\nE: DEVNAME=/dev/" << node
       << "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nE: BUSNUM=001\nE: DEVNUM=" << number("%03d", address)
       << "\nA: busnum=1\\n\nA: devnum=" << address << "\\n\nA: bConfigurationValue=1\\n\nA: speed="
       << (device.profile().speed == usb::UsbSpeed::high ? "480" : "12")
       << "\\n\nH: descriptors=" << hex(device.deviceAndConfiguration()) << "\n";
  return text.str();
}

}  // namespace

SysfsTestbed::SysfsTestbed() : testbed_(umockdev_testbed_new()) {
  if (!umockdev_in_mock_environment()) throw std::runtime_error("link the tests against libumockdev-preload");
  usb::UsbProfile hub;
  hub.vendor = 0x1d6b;
  hub.product = 0x0002;
  hub.interfaceClass = 9;
  addText(recordOf(usb::Descriptors(hub), 1));
}

SysfsTestbed::~SysfsTestbed() {
  g_object_unref(testbed_);
}

void SysfsTestbed::addText(const std::string& text) {
  GError* error = nullptr;
  if (umockdev_testbed_add_from_string(UMOCKDEV_TESTBED(testbed_), text.c_str(), &error)) return;
  const std::string why = error->message;
  g_error_free(error);
  throw std::runtime_error("umockdev: " + why);
}

void SysfsTestbed::add(const usb::Descriptors& device, int address) {
  addText(recordOf(device, address));
  umockdev_testbed_uevent(UMOCKDEV_TESTBED(testbed_), ("/sys" + pathOf(address)).c_str(), "add");
}

void SysfsTestbed::remove(int address) {
  const std::string path = "/sys" + pathOf(address);
  umockdev_testbed_uevent(UMOCKDEV_TESTBED(testbed_), path.c_str(), "remove");
  umockdev_testbed_remove_device(UMOCKDEV_TESTBED(testbed_), path.c_str());
}

}  // namespace haptiv::test
