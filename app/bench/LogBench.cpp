#include <filesystem>

#include "app/bench/Benches.h"
#include "app/bench/TemporaryLog.h"
#include "app/bench/scenes/ArmOnFloor.h"
#include "app/session/log/writing/SessionLogWriter.h"
#include "haptics/servo/FastLoop.h"

namespace haptiv {
namespace {

constexpr std::size_t kBlock = 500;  // [ticks]: what a session at 1 kHz brings to the disk at a time
constexpr std::size_t kBlocks = 40;

}  // namespace

void benchLog(BenchRun& run) {
  run.tell("log: " + std::to_string(kBlock * kBlocks) + " ticks");
  const ArmOnFloor arm;
  std::vector<TickRecord> ticks;
  runFast(*arm.device(), arm.description(), ArmOnFloor::kRate, arm.scene(), kBlock * kBlocks,
          [&](const TickRecord& record) {
            ticks.push_back(record);
            return true;
          });
  const TemporaryLog file;
  SessionHeader header;
  header.deviceText = arm.description().text;
  header.rate = ArmOnFloor::kRate;
  SessionLogWriter log(file.path(), header);
  log.addScene(arm.scene(), "#Inventor V2.1 ascii\n");
  CallTimes times(kBlocks);
  for (std::size_t i = 0; i < kBlocks; ++i) {
    times.time([&] {
      log.append({ticks.data() + i * kBlock, kBlock});
      return true;
    });
  }
  times.endPass();
  log.close(0);
  BenchResult result = resultOf("log/write", kBlock, times);
  result.medianNs /= kBlock;
  result.p99Ns /= kBlock;
  result.notes = {{"records_per_s", 1e9 / result.medianNs},
                  {"bytes_per_record",
                   static_cast<double>(std::filesystem::file_size(file.path())) / static_cast<double>(ticks.size())}};
  run.add(result);
}

}  // namespace haptiv
