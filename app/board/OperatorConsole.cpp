#include "app/board/OperatorConsole.h"

#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

std::string namesOf(std::uint32_t trips) {
  std::string names;
  for (const std::string& name : tripNames(trips)) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

bool OperatorConsole::obey(const std::string& typed) {
  for (const char c : typed) {
    if (c == 'q') return false;
    if (c == 'd') held_ ^= kInputDeadMan;
    if (c == 'e') held_ ^= kInputEmergencyStop1;
    if (c == 'r') resetAsked_ = true;
  }
  return true;
}

std::uint16_t OperatorConsole::inputs(std::chrono::nanoseconds now) {
  if (resetAsked_) resetUntil_ = now + std::chrono::milliseconds(100);
  resetAsked_ = false;
  return now < resetUntil_ ? static_cast<std::uint16_t>(held_ | kInputReset) : held_;
}

std::string BoardNews::newSince(const BoardReport& report, bool imported) {
  std::string news;
  const auto say = [&news](const std::string& what) { news += (news.empty() ? "" : "; ") + what; };
  if (imported != imported_) say(imported ? "a host has plugged the board in" : "the host has unplugged the board");
  if (report.driving != driving_) say(report.driving ? "the drives are on" : "the arm is braked");
  const std::uint32_t trips = report.reading.trips;
  if (trips != trips_) say(trips == kNoTrip ? "reset: no trip stands" : "tripped: " + namesOf(trips));
  imported_ = imported;
  driving_ = report.driving;
  trips_ = trips;
  return news;
}

}  // namespace haptiv
