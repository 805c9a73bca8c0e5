#include "app/session/Resimulation.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "app/session/log/contents/TickColumns.h"
#include "haptics/tick/HapticTick.h"

namespace haptiv {
namespace {

const HapticScene& sceneOf(const TickRecord& tick, const std::vector<LoggedScene>& scenes) {
  const auto found =
      std::lower_bound(scenes.begin(), scenes.end(), tick.sceneVersion,
                       [](const LoggedScene& scene, std::uint32_t version) { return scene.scene.version < version; });
  if (found == scenes.end() || found->scene.version != tick.sceneVersion)
    throw std::runtime_error("tick " + std::to_string(tick.tick) + " felt version " +
                             std::to_string(tick.sceneVersion) +
                             " of the scene, which is not there. The log is damaged: use another copy of it");
  return found->scene;
}

TickRecord again(const HapticTick& tick, const TickRecord& logged, const std::vector<LoggedScene>& scenes,
                 TickState& state) {
  TickRecord record = tick(sceneOf(logged, scenes), logged.reading, state, logged.missedTicks);
  record.tick = logged.tick;
  record.time = logged.time;
  record.wakeLateness = logged.wakeLateness;
  record.computeTime = logged.computeTime;
  return record;
}

/// A session can be computed again from its first tick on, by the program that knows its ticks.
void expectWhole(const SessionLog& log) {
  constexpr std::uint64_t kFirstWithStates = 2;
  if (log.formatVersion() < kFirstWithStates)
    throw std::runtime_error(
        "the log has format 1, of a Haptiv whose sessions had no states: it can be shown and exported, but not be "
        "re-simulated. Use the Haptiv that wrote it: `haptiv info` names its version");
  if (log.header().fault.empty() || log.tickCount() == 0) return;
  const std::uint64_t first = log.ticks(0, 1).front().tick;
  if (first > 0)
    throw std::runtime_error("this is the flight record of a fault (" + log.header().fault + ") and starts at tick " +
                             std::to_string(first) +
                             ", in the middle of a session: it can be shown and exported, but not be re-simulated. " +
                             "Use the log of the whole session, where one was written");
}

/// The results of a tick, column by column.
class Comparison {
 public:
  Comparison() {
    for (const TickGroup& group : tickGroups())
      for (const TickColumn& column : group.columns)
        if (column.result) columns_.push_back(column);
  }

  std::optional<Difference> operator()(const TickRecord& logged, const TickRecord& resimulated) const {
    for (const TickColumn& column : columns_) {
      std::array<std::byte, 8> left{}, right{};
      column.store(logged, left.data());
      column.store(resimulated, right.data());
      if (left != right) return Difference{logged.tick, column.name, column.value(logged), column.value(resimulated)};
    }
    return std::nullopt;
  }

 private:
  std::vector<TickColumn> columns_;
};

}  // namespace

void resimulate(const SessionLog& log, const std::vector<LoggedScene>& scenes, const ResimulationSink& sink) {
  expectWhole(log);
  const DeviceDescription description = parseDeviceDescription(log.header().deviceText, "the log's device description");
  const HapticTick tick(description, 1 / log.header().rate);
  TickState state;
  for (std::uint64_t first = 0; first < log.tickCount(); first += SessionLog::kBlock)
    for (const TickRecord& logged : log.ticks(first, SessionLog::kBlock))
      if (!sink(logged, again(tick, logged, scenes, state))) return;
}

Verification verify(const SessionLog& log) {
  const Comparison compare;
  Verification result;
  std::uint64_t newest = 0;
  resimulate(log, log.scenes(), [&](const TickRecord& logged, const TickRecord& resimulated) {
    newest = logged.tick;
    const std::uint64_t run = logged.tick - logged.missedTicks;  // ticks run before this one
    if (run != result.ticks) {
      result.first =
          Difference{logged.tick, "dropped_records", static_cast<double>(run), static_cast<double>(result.ticks)};
      return false;
    }
    ++result.ticks;
    result.first = compare(logged, resimulated);
    return result.identical();
  });
  if (result.identical() && log.dropped() > 0)  // the last ones, after all that the log holds
    result.first = Difference{newest, "dropped_records", static_cast<double>(result.ticks + log.dropped()),
                              static_cast<double>(result.ticks)};
  return result;
}

}  // namespace haptiv
