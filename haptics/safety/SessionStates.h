#pragma once

#include <cstdint>

namespace haptiv {

/// Where a session stands: what the arm may do.
enum class SessionState : std::uint8_t {
  idle,     ///< nothing has been read yet
  ready,    ///< the arm brakes; it moves once the operator presses the dead-man
  running,  ///< the scene is felt
  fault,    ///< the arm brakes until the operator resets
};

}  // namespace haptiv
