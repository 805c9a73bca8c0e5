#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "device/realtime/TripleBuffer.h"
#include "device/usb/falcon/FalconLogic.h"
#include "device/usb/falcon/FalconStream.h"
#include "device/usb/libusb/UsbClient.h"

namespace haptiv::falcon {

/// A Falcon's newest state, and whether it means anything.
struct Seen {
  State state;
  Homing homing = Homing::searching;
  std::uint64_t number = 0;  ///< of the states since the program began; 0: none
};

/// What became of the packets, since the program began.
struct Figures {
  std::uint64_t states = 0;   ///< whole
  std::uint64_t damaged = 0;  ///< dropped
  std::uint64_t sent = 0;     ///< orders
  std::uint64_t unasked = 0;  ///< of them because nothing else had happened
  std::uint64_t errors = 0;   ///< that the bus found
  std::uint64_t losses = 0;   ///< times that the device left
};

/// The host's end of a Falcon: sets it up, and speaks with it by turns: its firmware answers each order by a state, a
/// thousand times a second at most. An order goes out when the servo has written and the one before has been answered;
/// and where neither happens, all the same after kPatience of the packets without a state, which the serial chip sends
/// once a millisecond.
class Client : public usb::UsbClient {
 public:
  static constexpr int kPatience = 5;                           ///< packets
  using Firmware = std::function<std::vector<std::uint8_t>()>;  ///< may throw

  Client(const DeviceDescription& description, Firmware firmware);

  usb::StreamEndpoints prepare(usb::UsbHandle& handle) override;
  void received(std::span<const std::uint8_t> packet) noexcept override;
  void faulted(usb::TransferEnd) noexcept override { ++errors_; }
  std::size_t send(std::span<std::uint8_t> packet) noexcept override;
  void skip() noexcept override {}
  void lost() noexcept override;

  /// The newest state; false: the same as before. Thread: one.  Realtime-safe: yes.
  bool newest(Seen& seen) noexcept;
  /// What is asked from now on, for no longer than the description's watchdog time. Thread: one.  Realtime-safe: yes.
  void write(const DeviceCommand& command) noexcept;

  // Thread: any.
  bool isThere() const noexcept { return there_; }
  bool isStill() const noexcept { return still_; }  ///< the order that was answered last asks for no torque
  Figures figures() const noexcept { return {states_, damaged_, sent_, unasked_, errors_, losses_}; }

 private:
  struct Given {
    DeviceCommand command;
    std::int64_t writtenAt = 0;  ///< [ns]
  };

  Logic logic_;
  Firmware firmware_;
  std::int64_t watchdogTime_;  // [ns]
  TripleBuffer<Seen> seen_;
  TripleBuffer<Given> given_;

  // The link's.
  Stream stream_;
  Seen last_;
  bool answered_ = true;    // the last order
  bool sentStill_ = true;   // it asks for no torque
  int silent_ = kPatience;  // packets without a state since then

  std::atomic<bool> there_ = false, still_ = true;
  std::atomic<std::uint64_t> states_ = 0, damaged_ = 0, sent_ = 0, unasked_ = 0, errors_ = 0, losses_ = 0;
};

}  // namespace haptiv::falcon
