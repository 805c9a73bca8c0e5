#include "app/session/log/contents/SessionEvents.h"

#include <bit>

namespace haptiv {
namespace {

using Kind = SessionEvent::Kind;

std::uint32_t bitOf(const SessionEvent& event) {
  return event.code >= 0 && event.code < 32 ? 1u << event.code : 0u;
}

}  // namespace

const char* nameOf(Kind kind) noexcept {
  switch (kind) {
    case Kind::state:
      return "state";
    case Kind::fault:
      return "fault";
    case Kind::trip:
      return "trip";
  }
  return "unknown";
}

std::string nameOf(const SessionEvent& event) {
  switch (event.kind) {
    case Kind::state:
      return nameOf(static_cast<SessionState>(event.code));
    case Kind::fault:
      return faultList(bitOf(event));
    case Kind::trip: {
      const std::vector<std::string> names = tripNames(bitOf(event));
      return names.empty() ? "none" : names.front();
    }
  }
  return "unknown";
}

void EventFinder::take(const TickRecord& record, const std::function<void(const SessionEvent&)>& found) {
  const auto tell = [&](Kind kind, std::int64_t code) { found({record.tick, record.time, kind, code}); };
  const auto tellBits = [&](Kind kind, std::uint32_t fresh) {
    for (; fresh != 0; fresh &= fresh - 1) tell(kind, std::countr_zero(fresh));
  };
  tellBits(Kind::trip, record.reading.trips & ~trips_);
  tellBits(Kind::fault, record.faults & ~faults_);
  if (!started_ || record.state != state_) tell(Kind::state, static_cast<std::int64_t>(record.state));
  started_ = true;
  state_ = record.state;
  faults_ = record.faults;
  trips_ = record.reading.trips;
}

}  // namespace haptiv
