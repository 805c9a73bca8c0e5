#include "haptics/safety/SessionStates.h"

#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

/// Where no fault stands in the way.
SessionState afterInputs(const SessionStates& session, bool deadMan) noexcept {
  switch (session.now) {
    case SessionState::ready:
      return deadMan && session.mayStart ? SessionState::running : SessionState::ready;
    case SessionState::running:
      return deadMan ? SessionState::running : SessionState::ready;
    default:
      return SessionState::ready;
  }
}

}  // namespace

const char* nameOf(SessionState state) noexcept {
  switch (state) {
    case SessionState::idle:
      return "idle";
    case SessionState::ready:
      return "ready";
    case SessionState::running:
      return "running";
    case SessionState::fault:
      return "fault";
  }
  return "unknown";
}

SessionStates next(SessionStates session, std::uint16_t inputs, std::uint32_t wrong) noexcept {
  const bool deadMan = (inputs & kInputDeadMan) != 0;
  const bool reset = (inputs & kInputReset) != 0;
  if (session.now == SessionState::idle && (wrong & kFaultDisconnected) != 0) return session;
  if (wrong != kNoFault) {
    if (session.now != SessionState::fault) session.resetReleased = false;
    session.faults |= wrong;
    session.now = SessionState::fault;
  } else if (session.now != SessionState::fault) {
    session.now = afterInputs(session, deadMan);
  } else if (reset && session.resetReleased && !deadMan) {
    session.faults = kNoFault;
    session.now = SessionState::ready;
  }
  session.resetReleased = session.resetReleased || !reset;
  session.mayStart = !deadMan;
  return session;
}

}  // namespace haptiv
