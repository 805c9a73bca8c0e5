#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "device/usb/libusb/UsbEvents.h"
#include "device/usb/libusb/UsbHotPlug.h"
#include "device/usb/libusb/UsbStream.h"

namespace haptiv::usb {

/// One device of a kind, kept at hand: opened, streamed by a thread of its own, let go when it leaves, and opened again
/// when it is plugged in again: the same serial number, whatever the port, or, if it was chosen by its port, in that.
/// One client, several links can exist.
///
///     plugged in -> open, claim, client.prepare -> packets
///     unplugged  -> client.lost, every transfer back, release, close -> waits for the next time
///
/// Thread: construct, open, close and destroy on one.
class UsbLink {
 public:
  /// @param which  its serial number or port; empty: the only one there is
  UsbLink(UsbKind kind, std::string which, UsbClient& client);
  ~UsbLink();
  UsbLink(const UsbLink&) = delete;
  UsbLink& operator=(const UsbLink&) = delete;

  /// Throws UsbFailure where the device cannot be used; nothing runs then. Open already: nothing.
  void open();
  /// Waits until every transfer is back. Safe to call twice.
  void close();

  /// The client has something to send. Thread: any. Realtime-safe: one system call that never blocks.
  void wake() noexcept { events_.wake(); }

  /// Runs `work`, control requests, between two streams, and waits for it; throws what it throws, and UsbFailure where
  /// no device is there.
  void betweenStreams(std::function<void(UsbHandle&)> work);

  /// Why the device is not there now; empty: it is. Thread: any, not the servo.
  std::string trouble() const;
  /// Serial number of the device that was opened last. Thread: any, not the servo.
  std::string serial() const;

 private:
  static constexpr auto kNever = std::chrono::steady_clock::time_point::max();
  using Work = std::packaged_task<void(UsbHandle*)>;  // null: no device is there

  void connect();
  void run();
  void step();
  std::chrono::milliseconds patience() const;
  void listen();
  void drain();
  void leave();
  void reconnect();
  void failed(const std::string& trouble, bool mayYetBe);
  void doWork();
  void tell(const std::string& trouble);

  UsbKind kind_;
  std::string which_;  // once opened, the device's serial number, if it has one and nothing was chosen
  UsbClient& client_;
  UsbContext context_;
  UsbEvents events_;
  std::unique_ptr<UsbHotPlug> hotPlug_;
  std::unique_ptr<UsbHandle> handle_;
  StreamEndpoints endpoints_;
  std::unique_ptr<UsbStream> stream_;
  std::chrono::steady_clock::time_point tryAgain_ = kNever;  // to open a device that is there
  std::thread thread_;
  std::atomic<bool> running_ = false;

  mutable std::mutex mutex_;
  std::string trouble_;
  std::string openedSerial_;
  Work work_;
};

}  // namespace haptiv::usb
