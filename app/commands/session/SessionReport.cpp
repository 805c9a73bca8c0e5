#include "app/commands/session/SessionReport.h"

#include "device/control/ControlNames.h"
#include "device/control/ResolutionNames.h"
#include "haptics/safety/Clamps.h"

namespace haptiv {
namespace {

Report reportOf(const TimeDistribution& times) {
  Report report;
  const auto add = [&](const char* name, std::int64_t time) { report.add(name, static_cast<std::uint64_t>(time)); };
  add("p50_ns", times.quantile(0.5));
  add("p99_ns", times.quantile(0.99));
  add("p999_ns", times.quantile(0.999));
  add("max_ns", times.longest);
  return report;
}

}  // namespace

double sessionSeconds(const TickRecord& last, double rate) {
  return static_cast<double>(last.tick + 1) / rate;
}

void addResolution(Report& report, const ResolutionChoice& choice) {
  report.add("strategy", nameOf(choice.strategy));
  report.add("solution", nameOf(choice.solution));
}

void addTiming(Report& report, const SessionTiming& timing) {
  report.addPart("wake_up", reportOf(timing.wakeUps));
  report.addPart("tick_time", reportOf(timing.ticks));
  report.add("servo_processor_share", timing.processorShare);
}

void addControl(Report& report, const ControlChoice& choice) {
  report.add("control", nameOf(choice.display));
  report.add("joints", nameOf(choice.joints));
  report.add("orientation", nameOf(choice.orientation));
  report.add("passivity", choice.passivity);
}

Report reportOf(const SessionSummary& summary, double rate) {
  const TickRecord& last = summary.last;
  Report report;
  report.add("seconds", summary.ticks > 0 ? sessionSeconds(last, rate) : 0.0);
  report.add("rate_Hz", rate);
  report.add("ticks", summary.ticks);
  report.add("missed_ticks", summary.missedTicks);
  report.add("dropped_records", summary.droppedRecords);
  report.add("max_force_N", summary.maxForce);
  report.add("max_penetration_m", summary.maxPenetration);
  report.add("contacts", summary.contacts);
  report.add("final_position_m", numbers(last.position));
  report.add("final_contact_force_N", last.environmentForce.norm());
  report.add("final_penetration_m", last.penetration);
  report.add("state", nameOf(last.state));
  report.add("faults", faultNames(last.faults));
  report.add("trips", tripNames(last.reading.trips));
  report.add("clamps", clampNames(summary.clamps));
  Report::Names flights;
  for (const std::filesystem::path& file : summary.flights) flights.push_back(file.string());
  report.add("flight_records", std::move(flights));
  return report;
}

}  // namespace haptiv
