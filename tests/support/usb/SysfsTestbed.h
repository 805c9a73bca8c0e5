#pragma once

#include <string>

#include "device/usb/protocol/Descriptors.h"

namespace haptiv::test {

/// What sysfs, /dev and udev would show of virtual devices, by umockdev: libusb finds devices by it and is told when
/// they come and go. All of them stand on bus 1, behind a root hub.
class SysfsTestbed {
 public:
  SysfsTestbed();
  ~SysfsTestbed();
  SysfsTestbed(const SysfsTestbed&) = delete;
  SysfsTestbed& operator=(const SysfsTestbed&) = delete;

  void add(const usb::Descriptors& device, int address);
  void remove(int address);

 private:
  void addText(const std::string& text);

  void* testbed_;
};

}  // namespace haptiv::test
