#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "device/board/BoardSignals.h"

namespace haptiv {

/// The operator's buttons as letters typed into a terminal.
class OperatorConsole {
 public:
  static constexpr const char* kHelp =
      "Type, and press Enter: d: press or release the dead-man's button; e: press or release the emergency stop; r: "
      "reset; q: quit.\n";

  /// False: the operator wants to end. Other letters do nothing.
  bool obey(const std::string& typed);
  /// What is pressed at this time: OperatorInput bits. A reset is pressed for a tenth of a second.
  std::uint16_t inputs(std::chrono::nanoseconds now);

 private:
  std::uint16_t held_ = 0;
  bool resetAsked_ = false;
  std::chrono::nanoseconds resetUntil_{};
};

/// What happens at the board, for a terminal: who has it, whether it drives, why it stopped.
class BoardNews {
 public:
  /// What has changed since the last call, in a line; empty: nothing.
  std::string newSince(const BoardReport& report, bool imported);

 private:
  bool imported_ = false, driving_ = false;
  std::uint32_t trips_ = kNoTrip;
};

}  // namespace haptiv
