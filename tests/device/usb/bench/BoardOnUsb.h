#pragma once

#include "device/usb/virtual/VirtualBoard.h"
#include "tests/support/usb/VirtualUsbDevice.h"

namespace haptiv::test {

/// The virtual board on the bench's bus, with what can be wrong about a board, and an operator who does what the test
/// says. Switched on, it has no zero and no host.
class BoardOnUsb : public VirtualUsbDevice {
 public:
  BoardOnUsb(const DeviceDescription& description, const std::string& serial, UsbSpeed speed = UsbSpeed::high)
      : description_(description),
        virtual_({description, speed == UsbSpeed::high ? usb::FrameForm::full : usb::FrameForm::packed, serial, false},
                 std::make_unique<Operator>(hand)) {}

  const usb::Descriptors& descriptors() const override { return virtual_.control().descriptors(); }
  usb::ControlAnswer answer(const usb::SetupPacket& setup, std::span<const std::uint8_t> data) override {
    usb::ControlAnswer answer = virtual_.control().answer(setup, data);
    if (otherVersion != 0 && !setup.isStandard() && answer && answer->size() > 2) (*answer)[2] = otherVersion;
    return answer;
  }
  bool isOpen(std::uint8_t endpoint) const override { return virtual_.control().isOpen(endpoint); }
  std::optional<Bytes> packetIn(std::uint8_t) override {
    std::array<std::uint8_t, usb::kLargestFrame> out{};
    const auto bytes = virtual_.port().packetIn(out);
    return Bytes(bytes.begin(), bytes.end());
  }
  void packetOut(std::uint8_t, std::span<const std::uint8_t> packet) override { virtual_.port().packetOut(packet); }

  void advance(std::int64_t interval) override {
    for (std::int64_t done = 0; done < interval; done += usb::VirtualBoard::kStep) {
      watch(board().demand());
      virtual_.press(buttons);
      virtual_.advance();
    }
  }
  /// Power comes by the cable unless the test says otherwise.
  void powered(bool on) override {
    if (!on && !ownSupply) virtual_.restart();
  }

  /// As `UsbDevice` is told when it shall home the arm where it stands.
  usb::HomeCounts countsHere() const { return description_.countsAt(virtual_.angles()); }
  const Board& board() const { return virtual_.board(); }

  std::uint16_t buttons = 0;      ///< OperatorInput bits
  HandTarget hand;                ///< at the handle; its own inputs do not count
  bool ownSupply = false;         ///< it lives on when it is unplugged
  std::uint8_t otherVersion = 0;  ///< of the protocol that it answers with; 0: the right one
  long unsafe = 0;                ///< set-points that the drives should never have been given

 private:
  struct Operator : HandSource {
    explicit Operator(const HandTarget& from) : target(from) {}
    HandTarget at(double) noexcept override {
      HandTarget now = target;
      now.inputs = 0;
      return now;
    }
    const HandTarget& target;
  };
  void watch(const DriveDemand& demand) {
    const DeviceDescription& d = description_;
    const JointVector& limit = demand.mode == DriveMode::rate ? d.drives.rateLimit : d.drives.torqueLimit;
    const bool safe = (demand.setPoints.array().abs() <= limit.array() * (1 + 1e-9)).all();
    const bool still = !demand.braked || demand.setPoints.isZero(0);
    if (!safe || !still) ++unsafe;
  }

  DeviceDescription description_;
  usb::VirtualBoard virtual_;
};

}  // namespace haptiv::test
