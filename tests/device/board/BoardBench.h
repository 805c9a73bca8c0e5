#pragma once

#include "device/board/Board.h"

namespace haptiv::test {

/// A board, its wires, its operator and its host, on a clock of its own: a host that ticks at 1 kHz.
struct BoardBench {
  static constexpr std::int64_t kTick = 1'000;  // [us]

  /// One tick: the host's command, if it lives, then the board's own look at its wires, four times.
  void tick(int count = 1) {
    for (int i = 0; i < count; ++i) {
      if (hostLives) last = send();
      for (int k = 0; k < 4; ++k) look(kTick / 4);
    }
  }
  void look(std::int64_t passed) { board.advance(now += passed, inputs); }

  Acceptance send() {
    ++command.sequence;
    ++command.heartbeat;
    return board.accept(command);
  }

  void press(std::uint16_t buttons) { inputs.buttons |= buttons; }
  void release(std::uint16_t buttons) { inputs.buttons &= static_cast<std::uint16_t>(~buttons); }

  /// The operator takes the handle and the host enables the drives.
  void drive(double rate = 0.5) {
    command.drive.enabled = true;
    command.drive.jointRates.setConstant(rate);
    tick();
    press(kInputDeadMan);
    tick();
  }
  /// What the operator does after a stop.
  void rearm() {
    release(kInputDeadMan | kInputReset);
    tick();
    press(kInputReset);
    tick();
    release(kInputReset);
    press(kInputDeadMan);
    tick();
  }

  bool drives() const { return !board.demand().braked; }
  std::uint32_t trips() const { return board.report().reading.trips; }

  DeviceDescription description = loadDeviceDescription("vishard10");
  Board board{boardSettings(description)};
  BoardInputs inputs;
  BoardCommand command;
  Acceptance last = Acceptance::accepted;
  bool hostLives = true;
  std::int64_t now = 0;
};

}  // namespace haptiv::test
