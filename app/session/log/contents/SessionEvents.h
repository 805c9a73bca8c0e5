#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// Something of a session that is worth a line of its own.
struct SessionEvent {
  enum class Kind : std::uint8_t { state, fault, trip };

  std::uint64_t tick = 0;
  std::int64_t time = 0;  ///< since the session's start [ns]
  Kind kind = Kind::state;
  std::int64_t code = 0;  ///< the SessionState; of a fault or a trip, which bit

  bool operator==(const SessionEvent&) const = default;
};

/// "state", "fault", "trip".
const char* nameOf(SessionEvent::Kind kind) noexcept;
/// Of the state, the fault or the trip, such as "tracking error".
std::string nameOf(const SessionEvent& event);

/// Finds the events of a session, tick by tick: every change of its state, every fault and every trip that is new.
class EventFinder {
 public:
  void take(const TickRecord& record, const std::function<void(const SessionEvent&)>& found);

 private:
  bool started_ = false;
  SessionState state_ = SessionState::idle;
  std::uint32_t faults_ = kNoFault;
  std::uint32_t trips_ = kNoTrip;
};

}  // namespace haptiv
