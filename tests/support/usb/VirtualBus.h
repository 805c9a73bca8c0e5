#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "tests/support/usb/SysfsTestbed.h"
#include "tests/support/usb/VirtualPort.h"

namespace haptiv::test {

/// A USB bus without hardware, below the real libusb: what it asks of the kernel is answered by models of devices
/// (VirtualUsbDevice). Its time is the test's: nothing moves on the wire but by `tick`.
///
///     VirtualBus bus;
///     VirtualPort& port = bus.plug(std::make_shared<SomeDevice>());
///     ... open it through libusb, on any thread ...
///     bus.tick();          // one interval, and what the host made of it
///     port.faults.lose = 1;
///     bus.unplug(port);
///
/// An alarm of the host's (timerfd, so long from now) rings by the bus's time too, at the end of the interval in which
/// it is due; those by an absolute time are left alone, which are libusb's time limits.
///
/// One bus at a time, and it is there before libusb is started: the functions of libc that libusb calls are replaced
/// for the whole program (UsbfsShim.cpp). Thread: any one at a time, while libusb has threads of its own.
class VirtualBus {
 public:
  enum class Clock {
    test,  ///< time goes on with `tick`
    wall,  ///< a thread calls `step` by the wall clock, by which alarms ring too
  };

  explicit VirtualBus(Clock clock = Clock::test);
  ~VirtualBus();
  VirtualBus(const VirtualBus&) = delete;
  VirtualBus& operator=(const VirtualBus&) = delete;

  VirtualPort& plug(std::shared_ptr<VirtualUsbDevice> device);
  /// The files that are open on it learn it at once, udev's listeners after that.
  void unplug(VirtualPort& port);
  /// For a thread between whose steps no one waits, by a wall clock: one interval of all devices.
  void step();
  /// So many intervals; after each, waits until the host has done all that it set off.
  void tick(int intervals = 1);
  /// Waits until the host has nothing left to do. Throws std::runtime_error where that takes half a minute.
  void settle();
  /// Whether the host waits for a transfer.
  bool isAsked() { return !awaited().empty(); }

  // The kernel's door, for the shim. Nothing: not a device of this bus.
  static VirtualBus* installed();
  std::optional<int> open(const char* path);  ///< a file descriptor, or a negative error number
  std::optional<int> control(int descriptor, unsigned long request, void* argument);  ///< zero, or an error number
  void closing(int descriptor);
  bool setAlarm(int descriptor, std::int64_t after);  ///< so long from now [us]; false: the bus does not keep time

 private:
  std::vector<int> awaited();
  void ringAlarms();

  Clock clock_;
  std::mutex mutex_;
  SysfsTestbed sysfs_;
  std::list<VirtualPort> ports_;  // unplugged ones too: files may still be open
  int nextAddress_ = 2;
  std::int64_t now_ = 0;                // [us]
  std::map<int, std::int64_t> alarms_;  // when they ring, by their descriptors [us]
};

}  // namespace haptiv::test
