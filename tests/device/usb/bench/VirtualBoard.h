#pragma once

#include <cmath>

#include "device/board/Board.h"
#include "device/simulated/plant/SimulatedArm.h"
#include "device/usb/BoardPort.h"
#include "device/usb/protocol/Descriptors.h"
#include "tests/support/usb/VirtualUsbDevice.h"

namespace haptiv::test {

/// The interface board as a USB device: the firmware's own logic (Board, BoardPort), with a simulated arm behind it and
/// an operator who presses what the test says. Switched on, it has no zero and no host.
class VirtualBoard : public VirtualUsbDevice {
 public:
  VirtualBoard(const DeviceDescription& description, std::string serial, UsbSpeed speed = UsbSpeed::high)
      : description_(description),
        serial_(std::move(serial)),
        speed_(speed),
        arm_(description, description.homeAngles, 1),
        board_(boardSettings(description)) {
    begin();
  }

  usb::FrameForm form() const { return speed_ == UsbSpeed::high ? usb::FrameForm::full : usb::FrameForm::packed; }

  UsbDescriptors descriptors() const override {
    return {usb::kVendorId,
            usb::kProductId,
            "Haptiv",
            "Haptiv interface board",
            serial_,
            speed_,
            usb::kBoardClass,
            usb::kBoardSubclass,
            usb::kBoardProtocol,
            {{usb::kStateEndpoint, 3, usb::statePacket(form()), 1},
             {usb::kCommandEndpoint, 3, usb::kCommandPacket, 1}}};
  }
  std::optional<Bytes> controlIn(const UsbSetup& setup) override {
    if (setup.type != 0xc1) return std::nullopt;
    usb::ControlBytes out{};
    const auto bytes = port_->controlIn(setup.request, out);
    if (bytes.empty()) return std::nullopt;
    Bytes answer(bytes.begin(), bytes.end());
    if (otherVersion != 0) answer[2] = otherVersion;
    return answer;
  }
  bool controlOut(const UsbSetup& setup, std::span<const std::uint8_t> bytes) override {
    return setup.type == 0x41 && port_->controlOut(setup.request, bytes);
  }
  std::optional<Bytes> packetIn(std::uint8_t) override {
    std::array<std::uint8_t, usb::kLargestFrame> out{};
    const auto bytes = port_->packetIn(out);
    return Bytes(bytes.begin(), bytes.end());
  }
  void packetOut(std::uint8_t, std::span<const std::uint8_t> packet) override { port_->packetOut(packet); }

  void advance(std::int64_t interval) override {
    constexpr std::int64_t kStep = 125;  // [us]
    for (std::int64_t done = 0; done < interval; done += kStep) {
      const DriveDemand demand = board_.demand();
      watch(demand);
      arm_.advance(demand, hand, 1e-6 * kStep);
      BoardInputs inputs = arm_.measure();
      inputs.buttons = buttons;
      board_.advance(now_ += kStep, inputs);
    }
  }
  /// Power comes by the cable unless the test says otherwise.
  void powered(bool on) override {
    if (on || ownSupply) return;
    begin();
  }

  /// As `UsbDevice` is told when it shall home the arm where it stands.
  usb::HomeCounts countsHere() const { return arm_.encoderCounts(); }
  const Board& board() const { return board_; }
  const SimulatedArm& arm() const { return arm_; }

  std::uint16_t buttons = 0;      ///< OperatorInput bits
  HandTarget hand;                ///< at the handle
  bool ownSupply = false;         ///< it lives on when it is unplugged
  std::uint8_t otherVersion = 0;  ///< of the protocol that it answers with; 0: the right one
  long unsafe = 0;                ///< set-points that the drives should never have been given

 private:
  /// Switched on: it knows its wires before the bus speaks to it.
  void begin() {
    board_ = Board(boardSettings(description_));
    board_.advance(now_, arm_.measure());
    const auto joints = static_cast<std::uint8_t>(description_.jointCount());
    port_.emplace(board_, form(), usb::Identity{0x0102, joints, description_.name});
  }
  void watch(const DriveDemand& demand) {
    const DeviceDescription& d = description_;
    const JointVector& limit = demand.mode == DriveMode::rate ? d.drives.rateLimit : d.drives.torqueLimit;
    const bool safe = (demand.setPoints.array().abs() <= limit.array() * (1 + 1e-9)).all();
    const bool still = !demand.braked || demand.setPoints.isZero(0);
    if (!safe || !still) ++unsafe;
  }

  DeviceDescription description_;
  std::string serial_;
  UsbSpeed speed_;
  SimulatedArm arm_;
  Board board_;
  std::optional<usb::BoardPort> port_;
  std::int64_t now_ = 0;
};

}  // namespace haptiv::test
