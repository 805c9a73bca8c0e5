#include "tests/app/replay/TestLog.h"

#include <set>
#include <stdexcept>

#include "app/session/log/writing/SessionLogWriter.h"

namespace haptiv {

TickRecord testTick(std::uint64_t tick) {
  TickRecord record;
  record.tick = tick;
  record.time = static_cast<std::int64_t>(tick) * 1'000'000;
  const double t = static_cast<double>(tick) * 1e-3;
  record.position = Vector3(t, -t, 0.5);
  record.handForce = Vector3(0, 0, t);
  record.environmentForce = Vector3(-2 * t, 0, 0);
  record.reading.encoderCounts[0] = static_cast<std::int32_t>(tick);
  return record;
}

std::vector<TickRecord> testTicks(std::uint64_t count, const std::function<bool(std::uint64_t)>& missed) {
  std::vector<TickRecord> ticks;
  for (std::uint64_t tick = 0; tick < count; ++tick) {
    if (!missed || !missed(tick)) ticks.push_back(testTick(tick));
  }
  return ticks;
}

SessionLog TestLogs::make(const std::vector<TickRecord>& ticks, End end, std::uint64_t dropped) {
  if (!folder_.isValid()) throw std::runtime_error("no folder for the test's logs");
  const std::string path = folder_.filePath(QString("log%1.h5").arg(made_++)).toStdString();
  {
    SessionLogWriter writer(path, SessionHeader());
    std::set<std::uint32_t> versions = {0};
    for (const TickRecord& tick : ticks) versions.insert(tick.sceneVersion);
    for (const std::uint32_t version : versions) {
      HapticScene scene;
      scene.version = version;
      writer.addScene(scene, "scene " + std::to_string(version));
    }
    writer.append(ticks);
    writer.flush();
    if (end == End::orderly) writer.close(dropped);
  }
  return SessionLog(path);
}

}  // namespace haptiv
