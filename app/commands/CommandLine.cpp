#include "app/commands/CommandLine.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <iostream>

#include "app/commands/CheckCommand.h"
#include "app/commands/ExitCode.h"
#include "app/commands/InfoCommand.h"
#include "app/commands/KinematicsCommand.h"
#include "app/commands/ReplayCommand.h"
#include "app/commands/RunCommand.h"
#include "app/commands/WindowCommand.h"
#include "app/version.h"

namespace haptiv {
namespace {

constexpr const char* kExamples = R"(Examples:
  haptiv scenes/labyrinth.iv
  haptiv run scenes/labyrinth.iv --hand hand.csv --fast --log s.h5 --picture s.png
  haptiv replay s.h5 --verify
  haptiv info s.h5 --json
  haptiv check scenes/labyrinth.iv

Units are metres, newtons and seconds. Exit codes: 0 good, 1 not so (errors in a scene, a difference, a fault of the
arm), 2 wrong usage, 3 could not.)";

constexpr double kMinRate = 500, kMaxRate = 8000;  // [Hz]
constexpr double kMaxSeconds = 86400;              // a day

/// Everything the command line can say.
struct Options {
  std::string sceneOrLog;
  RunOptions run;
  CheckOptions check;
  ReplayOptions replay;
  InfoOptions info;
  KinematicsOptions kinematics;
};

/// A number above `low`, or at it where `closed`, and at most `high`; unlike CLI::Range, NaN is in no range.
CLI::Validator between(double low, bool closed, double high) {
  return {[=](std::string& text) -> std::string {
            double value = NAN;
            if (!CLI::detail::lexical_cast(text, value)) return text + " is no number";
            if ((value > low || (closed && value == low)) && value <= high) return {};
            return text + " is not " + (closed ? "from " : "above ") + CLI::detail::to_string(low) +
                   (closed ? " to " : " and at most ") + CLI::detail::to_string(high);
          },
          ""};
}

CLI::Validator notEmpty() {
  return {[](std::string& text) { return std::string(text.empty() ? "the name is empty" : ""); }, ""};
}

CLI::Option* addPath(CLI::App& command, const char* name, std::string& path, const char* help) {
  return command.add_option(name, path, help)->check(notEmpty());
}

void addJson(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "Print one JSON object to stdout instead of the table");
}

CLI::App& addRun(CLI::App& app, RunOptions& run) {
  CLI::App& command = *app.add_subcommand("run", "Run a session without a window");
  addPath(command, "SCENE", run.scene, "Scene to be felt (.iv)")->required();
  command.add_option("--device", run.device, "The arm: sim")->type_name("NAME")->capture_default_str();
  addPath(command, "--hand", run.hand,
          "Where the hand wants the ball, over time: a CSV file with the columns t,x,y,z in s and m, or rest: nobody "
          "holds the ball")
      ->type_name("FILE.csv")
      ->capture_default_str();
  command.add_option("--seconds", run.seconds, "How long; as long as the hand file and 1 s more, or 5 s")
      ->type_name("S")
      ->check(between(0, false, kMaxSeconds));
  command.add_option("--rate", run.rate, "Ticks per second, 500 to 8000")
      ->type_name("HZ")
      ->capture_default_str()
      ->check(between(kMinRate, true, kMaxRate));
  command.add_option("--strategy", run.strategy, "How the redundancy is resolved: nonopt")
      ->type_name("NAME")
      ->capture_default_str();
  addPath(command, "--log", run.log, "Log every tick to this HDF5 file")->type_name("FILE.h5");
  addPath(command, "--picture", run.picture, "Draw the end of the session, 1280 x 720; needs no display")
      ->type_name("FILE.png");
  command.add_flag("--fast", run.fast, "As fast as the machine allows, and repeatable bit for bit");
  command.add_flag("--solid", run.solid, "For meshes; not in this version");
  addJson(command, run.json);
  return command;
}

CLI::App& addReplay(CLI::App& app, ReplayOptions& replay) {
  CLI::App& command = *app.add_subcommand("replay", "Replay a session log; in the window if nothing else is asked for");
  addPath(command, "LOG", replay.log, "Session log (.h5)")->required();
  command.add_flag("--verify", replay.verify, "Re-simulate, compare bit for bit, and name the first difference");
  command.add_option("--set", replay.changes, "Re-simulate with this property changed; may be given several times")
      ->type_name("NODE.FIELD=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addPath(command, "--export", replay.exported, "Write the ticks as a table")->type_name("FILE.csv");
  addJson(command, replay.json);
  return command;
}

CLI::App& addCheck(CLI::App& app, CheckOptions& check) {
  CLI::App& command = *app.add_subcommand("check", "Load and judge a scene");
  addPath(command, "SCENE", check.scene, "Scene to be judged (.iv)")->required();
  addJson(command, check.json);
  return command;
}

CLI::App& addInfo(CLI::App& app, InfoOptions& info) {
  CLI::App& command = *app.add_subcommand("info", "Tell what a session log holds");
  addPath(command, "LOG", info.log, "Session log (.h5)")->required();
  addJson(command, info.json);
  return command;
}

CLI::App& addKinematics(CLI::App& app, KinematicsOptions& kinematics) {
  CLI::App& command = *app.add_subcommand("kinematics", "Pose, Jacobian and dexterity of VISHARD10");
  command.add_option("--q", kinematics.q, "Ten joint angles in rad, with commas between")
      ->type_name("Q1,...,Q10")
      ->required();
  addJson(command, kinematics.json);
  return command;
}

std::string version() {
  const std::string hash = kGitHash;
  return std::string("haptiv ") + kVersion + (hash.empty() ? "" : " (" + hash + ")");
}

/// Parses and does what was asked for. Throws CommandFailure and what the libraries below throw.
int dispatch(int argc, char** argv) {
  Options options;
  CLI::App app("Haptiv: Open Inventor scenes that a hand can feel", "haptiv");
  app.set_version_flag("--version", version());
  app.footer(kExamples);
  app.require_subcommand(0, 1);
  addPath(app, "SCENE|LOG", options.sceneOrLog, "Scene (.iv) or session log (.h5) to open in the window");

  std::function<int()> command = [&] { return openWindow(argc, argv, options.sceneOrLog); };
  addRun(app, options.run).callback([&] { command = [&] { return runSession(options.run); }; });
  addCheck(app, options.check).callback([&] { command = [&] { return checkScene(options.check); }; });
  addReplay(app, options.replay).callback([&] { command = [&] { return replayLog(argc, argv, options.replay); }; });
  addInfo(app, options.info).callback([&] { command = [&] { return describeLog(options.info); }; });
  addKinematics(app, options.kinematics).callback([&] { command = [&] { return describePose(options.kinematics); }; });
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    throw CommandFailure(kWrongUsage, std::string(error.what()) + "; haptiv --help shows what there is");
  }
  if (!options.sceneOrLog.empty() && !app.get_subcommands().empty())
    throw CommandFailure(kWrongUsage, options.sceneOrLog + ": what is this before the command? See haptiv --help");
  return command();
}

int fail(ExitCode code, const char* message) noexcept {
  std::cerr << "haptiv: " << message << "\n";
  return code;
}

}  // namespace

int runCommandLine(int argc, char** argv) noexcept {
  try {
    return dispatch(argc, argv);
  } catch (const CommandFailure& failure) {
    return fail(failure.code(), failure.what());
  } catch (const std::bad_alloc&) {
    return fail(kCouldNot, "out of memory; close other programs or use a smaller scene");
  } catch (const std::exception& error) {
    return fail(kCouldNot, error.what());
  } catch (...) {
    return fail(kCouldNot, "an unknown error");
  }
}

}  // namespace haptiv
