#include "tests/faults/ProgramCases.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "app/session/log/writing/SessionLogWriter.h"
#include "app/session/recording/SessionRecorder.h"
#include "haptics/servo/FastLoop.h"
#include "haptics/servo/ServoLoop.h"
#include "tests/faults/FaultChain.h"

namespace haptiv::faults {
namespace {

constexpr std::uint64_t kTicks = 10'000;  // as many as the ring cannot hold

/// Ten seconds of a servo whose records go where `sink` puts them; whether all its ticks were good.
template <typename Sink>
bool serve(Sink sink) {
  FaultChain chain;
  computeBounds(chain.scene);
  SimulatedDevice device(chain.description, chain.description.homeAngles, nullptr, 1);
  bool good = true;
  const std::uint64_t ran =
      runFast(device, chain.description, kRate, chain.scene, kTicks, [&](const TickRecord& record) {
        good = good && record.faults == kNoFault;
        sink(record);
        return true;
      });
  return good && ran == kTicks;
}

SessionHeader someHeader() {
  SessionHeader header;
  header.deviceText = FaultChain().description.text;
  return header;
}

/// The log's thread is gone, or hangs for good: nobody drains the ring.
ProgramCase killedLogWriter() {
  RecordRing<TickRecord> ring(8192);
  const bool good = serve([&](const TickRecord& record) { ring.push(record); });
  const bool counted = ring.dropped() > 0 && ring.dropped() < kTicks;
  return {"log writer killed", good && counted, "ticks that never reached the log are counted"};
}

ProgramCase fullDisk() {
  std::string folder = (std::filesystem::temp_directory_path() / "haptiv-faults-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("cannot create " + folder);
  std::atomic<std::uint64_t> space = 1u << 30;
  auto writer = std::make_unique<SessionLogWriter>(std::filesystem::path(folder) / "s.h5", someHeader(),
                                                   [&space](const std::filesystem::path&) { return space.load(); });
  RecordRing<TickRecord> ring(8192);
  SessionRecorder recorder(ring, std::move(writer));
  space = 0;
  const bool good = serve([&](const TickRecord& record) { ring.push(record); });
  recorder.stop();
  const bool told = recorder.trouble().find("nearly full") != std::string::npos;
  std::filesystem::remove_all(folder);
  return {"disk full", good && told, "the log ends and stays readable; the reason is told"};
}

/// Nobody reads what is to be shown, and no scene comes any more.
ProgramCase frozenWindow() {
  TripleBuffer<TickRecord> display;
  const bool good = serve([&](const TickRecord& record) { display.write(record); });
  display.update();
  return {"window frozen", good && display.read().tick == kTicks - 1, "the newest tick is shown once it goes on"};
}

}  // namespace

std::vector<ProgramCase> programFaults() {
  return {killedLogWriter(), fullDisk(), frozenWindow()};
}

}  // namespace haptiv::faults
