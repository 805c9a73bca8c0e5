#pragma once

#include <cstdint>
#include <string>

namespace haptiv {

/// Where a session stands: what the arm may do.
enum class SessionState : std::uint8_t {
  idle,     ///< nothing has been read yet
  ready,    ///< the arm brakes; it moves once the operator presses the dead-man
  running,  ///< the scene is felt
  fault,    ///< the arm brakes until the operator resets
};

inline constexpr int kSessionStateCount = 4;

/// "idle", "ready", "running", "fault".
const char* nameOf(SessionState state) noexcept;

/// The state of a session and what has led to it.
///
///     idle --a device answers--> ready --dead-man pressed--> running
///                                  ^ <--dead-man released------ |
///                                  |                            | any fault
///                                  `--reset-- fault <-----------'   (from ready too)
struct SessionStates {
  SessionState now = SessionState::idle;
  std::uint32_t faults = 0;    ///< Fault bits, latched until the reset
  bool mayStart = false;       ///< the dead-man has been seen released: pressing it now starts the arm
  bool resetReleased = false;  ///< in a fault: the reset button has been seen released, so it is not a jammed one
};

/// The state one tick later.
///
/// A fault comes first, whatever is pressed. It stays until the operator presses reset, while the dead-man is released
/// and nothing is wrong any more; then the dead-man starts the arm again. A dead-man that is pressed already when it
/// could start the arm has to be released first.
///
/// @param inputs  OperatorInput bits of this tick
/// @param wrong   Fault bits of this tick, not latched
/// Pure.  Realtime-safe: yes.
SessionStates next(SessionStates session, std::uint16_t inputs, std::uint32_t wrong) noexcept;

}  // namespace haptiv
