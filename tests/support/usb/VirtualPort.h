#pragma once

#include <list>
#include <memory>

#include "tests/support/usb/LineFaults.h"
#include "tests/support/usb/UsbFile.h"
#include "tests/support/usb/VirtualUsbDevice.h"

namespace haptiv::test {

/// Where a virtual device is plugged in: what the kernel's usbfs and the host controller do for it. Every ioctl of
/// libusb ends here. Thread: under the bus's lock.
class VirtualPort {
 public:
  VirtualPort(std::shared_ptr<VirtualUsbDevice> device, int address);

  int address() const { return address_; }
  const usb::Descriptors& descriptors() const { return device_->descriptors(); }
  std::int64_t interval() const { return descriptors().profile().speed == UsbSpeed::high ? 125 : 1000; }  ///< [us]

  /// A new opening's file descriptor.
  int open();
  /// Whether it was an opening of this device.
  bool close(int descriptor);
  bool has(int descriptor) const { return fileOf(descriptor) != nullptr; }
  /// Zero, or the error number.
  int control(int descriptor, unsigned long request, void* argument);

  /// The files that have transfers on their way: somebody is to wait for them.
  std::vector<int> awaited() const;
  /// One interval of the bus.
  void tick();
  void unplug();
  bool plugged() const { return plugged_; }

  LineFaults faults;
  bool permitted = true;  ///< the user may open it

 private:
  UsbFile* fileOf(int descriptor) const;
  UsbFile* waiting(std::uint8_t endpoint, usbdevfs_urb*& urb) const;
  int claim(UsbFile& file, unsigned interface);
  int submit(UsbFile& file, usbdevfs_urb* urb);
  int reap(UsbFile& file, void* argument);
  void answer(UsbFile& file, usbdevfs_urb* urb);
  /// A standard request of the kernel's own, without data.
  int tell(std::uint8_t recipient, usb::StandardRequest request, unsigned value, unsigned index = 0);
  void configure();
  void halt(std::uint8_t endpoint);
  void tickOut(std::uint8_t endpoint);
  void tickIn(std::uint8_t endpoint);
  std::optional<Bytes> nextPacket(std::uint8_t endpoint);
  void bring(UsbFile& file, usbdevfs_urb* urb, const Bytes& packet);

  std::shared_ptr<VirtualUsbDevice> device_;
  int address_;
  bool plugged_ = true;
  std::list<std::unique_ptr<UsbFile>> files_;
  std::optional<Bytes> held_;  // the packet that is overtaken, or comes again
};

}  // namespace haptiv::test
