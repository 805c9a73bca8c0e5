#include "app/commands/session/InfoCommand.h"

#include <memory>
#include <utility>

#include "app/commands/ExitCode.h"
#include "app/commands/NamedFile.h"
#include "app/commands/Report.h"
#include "app/commands/session/SessionReport.h"
#include "app/session/choices/SceneControl.h"
#include "app/session/choices/SceneResolution.h"
#include "app/session/log/reading/SessionLog.h"
#include "device/described/DeviceDescription.h"

namespace haptiv {
namespace {

struct InfoOptions {
  std::string log;
  bool json = false;
};

/// At the start of the session, and every time that the operator chose anew.
void addResolutions(Report& report, const SessionLog& log, const DeviceDescription& device) {
  ResolutionChoice choice =
      log.scenes().empty() ? device.redundancy.choice : resolutionOf(log.scenes().front().scene, device);
  addResolution(report, choice);
  Report::List changes;
  for (const LoggedScene& each : log.scenes()) {
    if (resolutionOf(each.scene, device) == choice) continue;
    choice = resolutionOf(each.scene, device);
    Report& change = changes.emplace_back();
    change.add("scene_version", std::uint64_t{each.scene.version});
    addResolution(change, choice);
  }
  report.add("resolution_changes", std::move(changes));
}

/// States, faults and trips, in order.
Report::List eventsOf(const SessionLog& log) {
  Report::List events;
  for (const SessionEvent& each : log.events()) {
    Report& event = events.emplace_back();
    event.add("tick", each.tick);
    event.add("time_s", static_cast<double>(each.time) / 1e9);
    event.add("kind", nameOf(each.kind));
    event.add("name", nameOf(each));
  }
  return events;
}

int describeLog(const InfoOptions& options) {
  requireReadable(options.log);
  const SessionLog log(options.log);
  const SessionHeader& header = log.header();
  TickRecord first, last;
  if (log.tickCount() > 0) {
    first = log.ticks(0, 1).front();
    last = log.ticks(log.tickCount() - 1, 1).back();
  }

  Report report;
  report.add("complete", log.complete());
  report.add("ticks", log.tickCount());
  report.add("duration_s", log.tickCount() > 0 ? static_cast<double>(last.tick - first.tick + 1) / header.rate : 0.0);
  report.add("rate_Hz", header.rate);
  report.add("scene", header.sceneName);
  report.add("scene_versions", std::uint64_t{log.scenes().size()});
  const DeviceDescription device = parseDeviceDescription(header.deviceText, options.log + " (its device description)");
  report.add("device", device.name);
  addResolutions(report, log, device);
  addControl(report, log.scenes().empty() ? device.control.choice : controlOf(log.scenes().front().scene, device));
  report.add("software_version", header.softwareVersion);
  report.add("git_hash", header.gitHash);
  report.add("start", header.startUtc.empty() ? Report::Value(nullptr) : header.startUtc);
  report.add("scheduling", header.scheduling);
  report.add("seed", header.seed);
  report.add("missed_ticks", std::uint64_t{last.missedTicks});
  report.add("dropped", log.dropped());
  report.add("flight_record_of", header.fault.empty() ? Report::Value(nullptr) : header.fault);
  report.add("first_tick", first.tick);
  report.add("state", nameOf(last.state));
  report.add("faults", faultNames(last.faults));
  report.add("trips", tripNames(last.reading.trips));
  report.add("events", eventsOf(log));
  report.print(options.json);
  return kGood;
}

}  // namespace

void addInfoCommand(const Command& program) {
  const auto options = std::make_shared<InfoOptions>();
  const Command info =
      program.add("info", "Tell what a session log holds", [options] { return describeLog(*options); });
  info.path("LOG", options->log, "Session log (.h5)").required();
  info.json(options->json);
}

}  // namespace haptiv
