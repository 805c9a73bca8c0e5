#pragma once

#include <memory>
#include <optional>
#include <string>

#include "device/simulated/Hand.h"
#include "device/simulated/SimulatedArm.h"
#include "device/usb/peripheral/ControlPipe.h"

namespace haptiv::usb {

/// What a virtual board is made as.
struct VirtualBoardSetup {
  DeviceDescription description;
  FrameForm form = FrameForm::full;
  std::string serial = "virtual-1";
  bool homed = true;       ///< false: as just switched on, its encoders at zero wherever the arm stands
  std::uint64_t seed = 1;  ///< of the sensor's noise
};

/// An interface board that is only a program, with a simulated arm and operator at its wires: what a bus asks it, it
/// answers as the hardware would. Its time is the caller's: a step is a microframe.
class VirtualBoard {
 public:
  static constexpr std::int64_t kStep = 125;  ///< [us]
  static constexpr std::uint16_t kFirmware = 0x0100;

  /// The arm stands in the description's home pose.
  /// @param hand  null: nobody at the handle. Its time begins with the first step
  /// Throws std::runtime_error where the serial is none.
  VirtualBoard(const VirtualBoardSetup& setup, std::unique_ptr<HandSource> hand);

  /// A microframe goes by. Realtime-safe: yes.
  void advance() noexcept;
  /// What the operator presses besides what the hand does: OperatorInput bits.
  void press(std::uint16_t inputs) noexcept { pressed_ = inputs; }
  /// Its supply has been away: the arm stays where it is, and the board has no zero, no host and its own thresholds.
  void restart();

  // What these give holds until it is restarted.
  BoardPort& port() noexcept { return circuit_->port; }
  ControlPipe& control() noexcept { return circuit_->control; }
  const ControlPipe& control() const noexcept { return circuit_->control; }
  const Board& board() const noexcept { return circuit_->board; }

  FrameForm form() const noexcept { return setup_.form; }
  BoardReport report() const noexcept { return board().report(); }
  const JointVector& angles() const noexcept { return arm_.angles(); }  ///< as they are [rad]

 private:
  /// What forgets when the supply is away.
  struct Circuit {
    Circuit(const BoardSettings& settings, const VirtualBoardSetup& setup);
    Board board;
    BoardPort port;
    ControlPipe control;
  };
  VirtualBoard(const VirtualBoardSetup& setup, const DeviceDescription& built, std::unique_ptr<HandSource> hand);

  VirtualBoardSetup setup_;
  BoardSettings settings_;
  SimulatedArm arm_;
  std::unique_ptr<HandSource> hand_;
  std::optional<Circuit> circuit_;
  std::uint16_t pressed_ = 0;
  std::int64_t now_ = 0;  // [us]
};

}  // namespace haptiv::usb
