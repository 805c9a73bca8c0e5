#include "app/CommandLine.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/commands/Command.h"
#include "app/commands/ExitCode.h"
#include "app/commands/WindowCommand.h"
#include "app/commands/device/BoardCommand.h"
#include "app/commands/device/DeviceCommand.h"
#include "app/commands/scene/CheckCommand.h"
#include "app/commands/scene/GenerateCommand.h"
#include "app/commands/session/InfoCommand.h"
#include "app/commands/session/ReplayCommand.h"
#include "app/commands/session/RunCommand.h"
#include "app/commands/study/BenchCommand.h"
#include "app/commands/study/ExperimentCommand.h"
#include "app/commands/study/KinematicsCommand.h"
#include "app/session/version.h"

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

std::string version() {
  const std::string hash = kGitHash;
  return std::string("haptiv ") + kVersion + (hash.empty() ? "" : " (" + hash + ")");
}

/// Parses and does what was asked for. Throws CommandFailure and what the libraries below throw.
int dispatch(int argc, char** argv) {
  CLI::App app("Haptiv: Open Inventor scenes that a hand can feel", "haptiv");
  app.set_version_flag("--version", version());
  app.footer(kExamples);
  app.require_subcommand(0, 1);

  std::string sceneOrLog;
  Command::Action chosen = [&] { return openWindow(argc, argv, sceneOrLog); };
  const Command program(app, chosen);
  program.path("SCENE|LOG", sceneOrLog, "Scene (.iv) or session log (.h5) to open in the window");
  addRunCommand(program);
  addCheckCommand(program);
  addReplayCommand(program, argc, argv);
  addGenerateCommand(program);
  addExperimentCommand(program);
  addInfoCommand(program);
  addKinematicsCommand(program);
  addBenchCommand(program);
  addDeviceCommand(program);
  addBoardCommand(program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    throw CommandFailure(kWrongUsage, std::string(error.what()) + "; haptiv --help shows what there is");
  }
  if (!sceneOrLog.empty() && !app.get_subcommands().empty())
    throw CommandFailure(kWrongUsage, sceneOrLog + ": what is this before the command? See haptiv --help");
  return chosen();
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
