#include "app/commands/device/DeviceMonitorCommand.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "app/commands/DeviceName.h"
#include "app/commands/ExitCode.h"
#include "app/commands/HeldSignals.h"
#include "app/commands/Report.h"
#include "app/session/UsbBoards.h"
#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds kTick{1000};
constexpr std::chrono::seconds kLine{1};
constexpr Range kMonitorLengths{0, 86400, true};  // [s], up to a day
constexpr int kBarLength = 50;                    // characters of the longest bar

struct MonitorOptions {
  std::string description = "vishard10";
  std::string device = "usb";
  std::optional<double> seconds;  // none: until Ctrl-C
  bool json = false;
};

std::string pressed(std::uint16_t inputs) {
  std::string text;
  if ((inputs & kInputDeadMan) != 0) text += " dead-man";
  if ((inputs & kInputEmergencyStops) != 0) text += " emergency-stop";
  if ((inputs & kInputReset) != 0) text += " reset";
  return text.empty() ? " nothing" : text;
}

std::string tripsOf(std::uint32_t trips) {
  std::string text;
  for (const std::string& name : tripNames(trips)) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// One line of what there is now, and of what came since the line before.
void printLine(const UsbDevice& device, const DeviceReading& reading, std::uint64_t states) {
  const usb::LinkFigures f = device.figures();
  const std::string trouble = device.trouble();
  std::cout << states << " states/s, lost " << f.missing << ", damaged " << f.damaged << ", late " << f.outOfOrder
            << ", errors " << f.errors + f.stalls + f.tooLong << "; counts";
  for (const std::int32_t count : reading.encoderCounts) std::cout << ' ' << count;
  std::cout << "; sensor";
  for (const std::int16_t count : reading.sensorCounts) std::cout << ' ' << count;
  std::cout << "; pressed" << pressed(reading.inputs) << "; trips: " << tripsOf(reading.trips)
            << (trouble.empty() ? "" : "; " + trouble) << std::endl;
}

/// The octaves of a distribution: from, up to, how often.
struct Octave {
  double from = 0, to = 0;  // [ns]
  std::uint64_t count = 0;
};

std::vector<Octave> octavesOf(const TimeDistribution& times) {
  std::vector<Octave> octaves;
  for (std::size_t begin = 0; begin < times.counts.size(); begin += TimeHistogram::kBinsPerOctave) {
    const std::size_t end = std::min(begin + TimeHistogram::kBinsPerOctave, times.counts.size());
    std::uint64_t count = 0;
    for (std::size_t bin = begin; bin < end; ++bin) count += times.counts[bin];
    if (count > 0 || !octaves.empty())
      octaves.push_back({static_cast<double>(TimeHistogram::beginOf(begin)),
                         static_cast<double>(TimeHistogram::beginOf(end)), count});
  }
  while (!octaves.empty() && octaves.back().count == 0) octaves.pop_back();
  return octaves;
}

void printHistogram(const TimeDistribution& times) {
  std::uint64_t most = 1;
  for (const Octave& octave : octavesOf(times)) most = std::max(most, octave.count);
  std::cout << "from command to echo:\n";
  for (const Octave& octave : octavesOf(times)) {
    std::array<char, 64> label{};
    std::snprintf(label.data(), label.size(), "  %8.0f us %9llu ", 1e-3 * octave.to,
                  static_cast<unsigned long long>(octave.count));
    const auto length =
        static_cast<std::size_t>(std::ceil(kBarLength * static_cast<double>(octave.count) / static_cast<double>(most)));
    std::cout << label.data() << std::string(length, '#') << "\n";
  }
}

Report reportOf(const UsbDevice& device, const std::string& serial, double seconds) {
  const usb::LinkFigures f = device.figures();
  const TimeDistribution latencies = device.latencies();
  Report report;
  report.add("serial", serial);
  report.add("high_speed", device.highSpeed());
  report.add("duration_s", seconds);
  report.add("state_rate_Hz", static_cast<double>(f.states) / seconds);
  for (const auto& [name, count] :
       std::initializer_list<std::pair<const char*, std::uint64_t>>{{"states", f.states},
                                                                    {"states_lost", f.missing},
                                                                    {"states_damaged", f.damaged},
                                                                    {"states_late", f.outOfOrder},
                                                                    {"stalls", f.stalls},
                                                                    {"overflows", f.tooLong},
                                                                    {"bus_errors", f.errors},
                                                                    {"commands", f.sent},
                                                                    {"commands_skipped", f.skipped},
                                                                    {"unplugged", f.losses}})
    report.add(name, count);
  report.add("latency_median_ns", static_cast<double>(latencies.quantile(0.5)));
  report.add("latency_p99_ns", static_cast<double>(latencies.quantile(0.99)));
  Report::Rows rows;
  for (const Octave& octave : octavesOf(latencies))
    rows.push_back({octave.from, octave.to, static_cast<double>(octave.count)});
  report.add("latency_histogram_ns", rows);
  return report;
}

int monitor(const MonitorOptions& options) {
  if (!isBoard(options.device))
    throw CommandFailure(kWrongUsage,
                         "--device " + options.device + ": give usb or usb:WHICH, as haptiv device list names them");
  refuseWithoutName(options.device);
  const HeldSignals held;
  UsbDeviceChoice choice{boardSerialOf(options.device), std::nullopt, true};
  UsbDevice device(loadDeviceDescription(options.description), choice);
  device.start(std::chrono::duration<double>(kTick).count());
  const std::string serial = device.serial();
  const auto start = Clock::now();
  const auto end = start + std::chrono::duration_cast<Clock::duration>(
                               std::chrono::duration<double>(options.seconds.value_or(kMonitorLengths.high)));
  auto line = start + kLine;
  std::uint64_t states = 0;
  for (auto due = start; due < end; due = std::max(due + kTick, Clock::now())) {
    if (held.pending(std::max<std::chrono::nanoseconds>(due - Clock::now(), std::chrono::nanoseconds(0)))) break;
    const DeviceReading reading = device.read();
    device.write({});  // brakes; its echo is what is timed
    if (options.json || due < line) continue;
    const std::uint64_t now = device.figures().states;
    printLine(device, reading, now - states);
    states = now;
    line += kLine;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  device.stop();
  if (!options.json) printHistogram(device.latencies());
  reportOf(device, serial, seconds).print(options.json);
  return kGood;
}

}  // namespace

void addDeviceMonitorCommand(const Command& device) {
  const auto options = std::make_shared<MonitorOptions>();
  const Command monitorCommand = device.add("monitor", "What an interface board says, live; its drives stay off",
                                            [options] { return monitor(*options); });
  monitorCommand.path("DESCRIPTION", options->description, "Of the arm: a built-in name, or a file (.toml)")
      .showDefault();
  monitorCommand
      .text("--device", options->device, "The board: usb, the only one, or usb:WHICH, by serial number or port")
      .type("NAME")
      .showDefault();
  monitorCommand.number("--seconds", options->seconds, kMonitorLengths, "How long; until Ctrl-C").type("S");
  monitorCommand.json(options->json);
}

}  // namespace haptiv
