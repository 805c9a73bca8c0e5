#pragma once

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/session/Session.h"
#include "app/session/log/reading/SessionLog.h"

namespace haptiv::testing {

/// A folder of its own for a test, gone after it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = ::testing::TempDir() + "haptiv-session-XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot create " + pattern);
    path_ = pattern;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

template <typename T>
bool sameBits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Every member of two records, without the padding between them; NaN equals the same NaN.
inline bool sameRecord(const TickRecord& a, const TickRecord& b) {
  return a.tick == b.tick && a.time == b.time && a.wakeLateness == b.wakeLateness && a.computeTime == b.computeTime &&
         a.missedTicks == b.missedTicks && a.sceneVersion == b.sceneVersion &&
         a.reading.encoderCounts == b.reading.encoderCounts && a.reading.sensorCounts == b.reading.sensorCounts &&
         a.reading.connected == b.reading.connected && sameBits(a.jointAngles, b.jointAngles) &&
         sameBits(a.desiredAngles, b.desiredAngles) && sameBits(a.position, b.position) &&
         sameBits(a.desiredPosition, b.desiredPosition) && sameBits(a.desiredVelocity, b.desiredVelocity) &&
         sameBits(a.handForce, b.handForce) && sameBits(a.environmentForce, b.environmentForce) &&
         sameBits(a.penetration, b.penetration) && a.contacts == b.contacts && a.zones == b.zones &&
         a.deepestWall == b.deepestWall && a.faults == b.faults && a.clamps == b.clamps && a.state == b.state &&
         a.reading.deviceTime == b.reading.deviceTime && a.reading.inputs == b.reading.inputs &&
         a.reading.trips == b.reading.trips && sameBits(a.handTorque, b.handTorque) &&
         sameBits(a.command.jointTorques, b.command.jointTorques) && sameBits(a.passivityEnergy, b.passivityEnergy) &&
         sameBits(a.passivityDamping, b.passivityDamping) && sameBits(a.command.jointRates, b.command.jointRates) &&
         a.command.enabled == b.command.enabled;
}

/// Records in which every bit is drawn, NaNs among them; tick and scene version are given.
class RandomRecords {
 public:
  explicit RandomRecords(std::uint64_t seed) : engine_(seed) {}

  TickRecord next(std::uint64_t tick, std::uint32_t sceneVersion) {
    TickRecord record;
    record.tick = tick;
    record.sceneVersion = sceneVersion;
    draw(record.time, record.wakeLateness, record.computeTime, record.missedTicks, record.reading.encoderCounts,
         record.reading.sensorCounts, record.jointAngles, record.desiredAngles, record.position, record.desiredPosition,
         record.desiredVelocity, record.handForce, record.environmentForce, record.penetration, record.contacts,
         record.zones, record.deepestWall, record.faults, record.clamps, record.reading.inputs, record.reading.trips,
         record.reading.deviceTime, record.handTorque, record.passivityEnergy, record.passivityDamping,
         record.command.jointRates, record.command.jointTorques);
    record.state = static_cast<SessionState>(engine_() % 4);
    record.reading.connected = engine_() % 2 == 0;
    record.command.enabled = engine_() % 2 == 0;
    return record;
  }
  std::vector<TickRecord> some(std::uint64_t first, std::size_t count, std::uint32_t sceneVersion = 0) {
    std::vector<TickRecord> records;
    for (std::size_t i = 0; i < count; ++i) records.push_back(next(first + i, sceneVersion));
    return records;
  }

 private:
  template <typename... T>
  void draw(T&... values) {
    (drawOne(values), ...);
  }
  template <typename T>
  void drawOne(T& value) {
    auto* bytes = reinterpret_cast<unsigned char*>(&value);
    for (std::size_t i = 0; i < sizeof value; ++i) bytes[i] = static_cast<unsigned char>(engine_());
  }

  std::mt19937_64 engine_;
};

inline SessionHeader someHeader() {
  SessionHeader header;
  header.sceneName = "scenes/wall.iv";
  header.sceneText =
      "#Inventor V2.1 ascii\n# Stra\xC3\x9F"
      "e\n";
  header.deviceText = "schema = 1\n";
  header.softwareVersion = "1.2.3";
  header.gitHash = "0123456789ab";
  header.startUtc = "2001-02-03T04:05:06Z";
  header.scheduling = "plain";
  header.seed = 0xFEDCBA9876543210u;
  header.rate = 1000;
  return header;
}

/// A box wall whose face towards -x lies at x = 0.05 m; the tool's home is the origin, well within the arm's reach.
inline HapticScene wallScene(double stiffness = 2000) {
  HapticScene scene;
  scene.device.position = Vector3(-0.35, 0, 0);
  Wall wall;
  wall.id = 7;
  wall.shape.centre = Vector3(0.1, 0, 0);
  wall.shape.axes = Vector3(0.05, 0.3, 0.3).asDiagonal();
  wall.surface.stiffness = stiffness;
  scene.walls.push_back(wall);
  computeBounds(scene);
  return scene;
}

/// The ball in a zone of 0.8 m edge length around the origin.
inline HapticScene zoneScene(Zone::Kind kind) {
  HapticScene scene;
  scene.device.position = Vector3(-0.35, 0, 0);
  Zone zone;
  zone.kind = kind;
  zone.shape.axes = Vector3(0.4, 0.4, 0.4).asDiagonal();
  scene.zones.push_back(zone);
  computeBounds(scene);
  return scene;
}

inline SessionSetup setupFor(HapticScene scene, std::vector<HandWaypoint> hand = {}) {
  SessionSetup setup;
  setup.scene = std::make_shared<const HapticScene>(std::move(scene));
  setup.sceneName = "test.iv";
  setup.sceneText = "#Inventor V2.1 ascii\n";
  setup.description = loadDeviceDescription("vishard10");
  setup.hand = std::move(hand);
  return setup;
}

/// What `call` throws, as text; a failure where it throws nothing.
template <typename Call>
std::string messageOf(Call&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

}  // namespace haptiv::testing
