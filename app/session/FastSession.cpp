#include <cmath>
#include <stdexcept>

#include "app/session/Session.h"
#include "app/session/SessionSeat.h"
#include "app/session/log/writing/SessionLogWriter.h"
#include "haptics/servo/FastLoop.h"

namespace haptiv {
namespace {

constexpr std::size_t kTicksToDisk = 8192;  // [ticks] brought to the disk at a time
constexpr double kLongestSession = 1e9;     // [ticks]

}  // namespace

SessionSummary runFast(const SessionSetup& setup, double seconds) {
  expectUsable(setup);
  const double ticks = std::round(seconds * setup.rate);
  if (!(ticks >= 1 && ticks <= kLongestSession))
    throw std::runtime_error("a session lasts from one tick to a billion of them: choose another number of seconds");
  const auto device = simulatedDevice(setup, scriptedHand(setup));
  const std::unique_ptr<FlightRecorder> flights = flightRecorder(setup, headerOf(setup));
  std::unique_ptr<SessionLogWriter> log;
  if (setup.log) {
    log = std::make_unique<SessionLogWriter>(*setup.log, headerOf(setup));
    log->addScene(*setup.scene, setup.sceneText.get());
  }
  SessionSummary summary;
  std::vector<TickRecord> block;
  const auto take = [&](const TickRecord& record) {
    summary.take(record);
    if (flights) flights->take(record);
    if (!log) return true;
    block.push_back(record);
    if (block.size() == kTicksToDisk) {
      log->append(block);
      block.clear();
    }
    return true;
  };
  runFast(*device, setup.description, setup.rate, *setup.scene, static_cast<std::uint64_t>(ticks), take);
  if (log) {
    log->append(block);
    log->close(0);
  }
  if (flights) summary.flights = flights->files();
  return summary;
}

}  // namespace haptiv
