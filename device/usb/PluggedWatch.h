#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "device/realtime/TripleBuffer.h"
#include "device/usb/PluggedDevices.h"
#include "device/usb/libusb/UsbEvents.h"
#include "device/usb/libusb/UsbHotPlug.h"

namespace haptiv {

/// Lists what is plugged in, on a thread of its own: whenever it is asked to, and, where libusb is told of it, whenever
/// something is plugged in or out. So nobody waits for a device that does not answer.
///
/// Thread: one; it never waits but at the end.
class PluggedWatch {
 public:
  struct Listing {
    std::vector<PluggedDevice> devices;
    std::string trouble;  ///< why they cannot be listed; empty: they are

    bool operator==(const Listing&) const = default;
  };

  /// Nothing is listed before it is asked to. Throws UsbFailure where libusb cannot be started, std::system_error.
  /// @param listed  is called on the watch's thread, after each listing
  explicit PluggedWatch(std::function<void(const Listing&)> listed);
  /// Waits for what is listed now: for usb::kAnswerLimit or twice that, where a device does not answer.
  ~PluggedWatch();
  PluggedWatch(const PluggedWatch&) = delete;
  PluggedWatch& operator=(const PluggedWatch&) = delete;

  /// Lists, now or after what is being listed.
  /// @param falconFirmware  file, from now on; empty: falcon::firmwarePath()
  void look(const std::string& falconFirmware);

  /// Lists nothing more until `resume`, so that devices can be opened: while one is listed nobody else can. False: it
  /// is listing still; `listed` is called once more, and then it rests.
  bool pause();
  /// What was plugged in or out meanwhile, or asked for, is listed now.
  void resume();

 private:
  void run(const std::stop_token& stop);
  bool begins();
  Listing list(const std::stop_token& stop);
  void recallSerials(std::vector<PluggedDevice>& devices);

  std::function<void(const Listing&)> listed_;
  usb::UsbContext context_;
  usb::UsbEvents events_;
  std::optional<usb::UsbHotPlug> hotPlug_;  // nothing: libusb is not told
  std::vector<PluggedDevice> last_;
  bool wanted_ = false;                 // a list; the watch's thread alone knows
  TripleBuffer<std::string> firmware_;  // written: a list is wanted
  std::atomic<unsigned> state_ = 0;     // kListing, kPaused

  std::jthread thread_;  // last: it uses all of these
};

}  // namespace haptiv
