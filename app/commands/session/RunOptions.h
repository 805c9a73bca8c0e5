#pragma once

#include <optional>
#include <string>

#include "app/commands/Command.h"

namespace haptiv {

/// What `haptiv run` is asked for. Empty paths and names: not asked for.
struct RunOptions {
  std::string scene;
  std::string device = "sim";
  std::string firmware;  ///< of a Falcon; empty: where it is looked for
  std::string hand = "rest";
  std::optional<double> seconds;  ///< none: as long as the hand file, and a second more
  double rate = 1000;             ///< [Hz]
  double spin = 50;               ///< [us]
  std::string strategy;           ///< empty, as those that follow: as the device description says
  std::string solution;
  std::string control;
  std::string joints;
  std::string orientation;
  std::string passivity;
  std::string log;
  std::string picture;
  bool solid = false;
  bool fast = false;
  bool json = false;
};

/// Declares them at `run`, and their help; `options` must live as long as the command's action.
void addRunOptions(const Command& run, RunOptions& options);

/// Whether a SpaceMouse leads the hand.
bool isLedBySpaceMouse(const RunOptions& options);
/// Whether a device holds the hand, not the simulated arm.
bool isOnDevice(const RunOptions& options);

/// Throws CommandFailure (kWrongUsage) where there is no such device, or where one option excludes another.
void refuseContradictions(const RunOptions& options);

}  // namespace haptiv
