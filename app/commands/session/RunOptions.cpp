#include "app/commands/session/RunOptions.h"

#include "app/commands/DeviceName.h"
#include "app/commands/ExitCode.h"
#include "app/session/Falcons.h"
#include "app/session/UsbBoards.h"
#include "app/session/hands/SpaceMouseChoice.h"
#include "haptics/servo/ServoPace.h"

namespace haptiv {
namespace {

constexpr Range kRates{kLowestServoRate, kHighestServoRate};
constexpr Range kSpins{0, 1000};                  // [us]
constexpr Range kSessionLengths{0, 86400, true};  // [s], up to a day

void addArmAndHand(const Command& run, RunOptions& options) {
  run.text(
         "--device", options.device,
         "The arm: sim; usb (usb:WHICH), an interface board; falcon (falcon:WHICH), a Novint Falcon; which there are, "
         "haptiv device list tells")
      .type("NAME")
      .showDefault();
  run.path("--firmware", options.firmware,
           "The Falcon's firmware, which its driver package holds; without this, ~/.local/share/haptiv/falcon.bin")
      .type("FILE");
  run.path(
         "--hand", options.hand,
         "Where the hand wants the ball, over time: a CSV file with the columns t,x,y,z in s and m; rest: nobody "
         "holds the ball; spacemouse or spacemouse:position: a SpaceMouse, whose cap says how fast or how far; :WHICH "
         "behind it where there are several")
      .type("FILE.csv")
      .showDefault();
}

void addTimes(const Command& run, RunOptions& options) {
  run.number("--seconds", options.seconds, kSessionLengths,
             "How long; as long as the hand file and 1 s more, or 5 s; until Ctrl-C where a person leads")
      .type("S");
  run.number("--rate", options.rate, kRates, "Ticks per second, 500 to 8000").type("HZ").showDefault();
  run.number(
         "--spin", options.spin, kSpins,
         "How long before each tick the servo waits awake, up to a quarter of the period: wakes in time, for a part "
         "of a processor")
      .type("US")
      .showDefault();
}

void addControl(const Command& run, RunOptions& options) {
  run.choice("--strategy", options.strategy, {"nonopt", "man", "dir", "cond"},
             "What the arm's redundancy serves; without this, as the device description says")
      .type("nonopt|man|dir|cond");
  run.choice("--solution", options.solution, {"full", "partitioned"},
             "All joints at once, or position and orientation apart; without this, as the device description says")
      .type("full|partitioned");
  run.choice("--control", options.control, {"admittance", "position-impedance", "impedance"},
             "What the device shows of the scene: a motion, or a force; without this, as the device description says")
      .type("admittance|position-impedance|impedance");
  run.choice("--joints", options.joints, {"pd", "computed-torque"},
             "How the joints follow the desired motion; without this, as the device description says")
      .type("pd|computed-torque");
  run.choice("--orientation", options.orientation, {"held", "free"},
             "Whether the hand can turn the handle; without this, as the device description says")
      .type("held|free");
  run.choice("--passivity", options.passivity, {"on", "off"},
             "Passivity control at the tool; without this, as the device description says")
      .type("on|off");
}

void addOutcomes(const Command& run, RunOptions& options) {
  run.path("--log", options.log, "Log every tick to this HDF5 file").type("FILE.h5");
  run.path("--picture", options.picture, "Draw the end of the session, 1280 x 720; needs no display").type("FILE.png");
}

void refuseWhatIsNotThere(const RunOptions& options) {
  if (options.device != "sim" && !isBoard(options.device) && !isFalcon(options.device))
    throw CommandFailure(kWrongUsage, "--device " + options.device +
                                          ": there is no such device; use sim, usb, usb:WHICH, falcon or falcon:WHICH, "
                                          "as haptiv device list names them");
  refuseWithoutName(options.device);
  if (isLedBySpaceMouse(options)) refuseWithoutName(options.hand);
  if (!options.firmware.empty() && !isFalcon(options.device))
    throw CommandFailure(kWrongUsage, "--firmware: is a Falcon's; give --device falcon too, or leave it out");
}

// A person moves it, and time is that person's.
void refuseWhatNoPersonCanDo(const RunOptions& options) {
  if (options.fast && (isOnDevice(options) || isLedBySpaceMouse(options)))
    throw CommandFailure(kWrongUsage, "--fast: a person cannot keep up with it; leave --fast out");
  if (isOnDevice(options) && options.hand != "rest")
    throw CommandFailure(kWrongUsage, "--hand " + options.hand +
                                          ": is for the simulated arm, others are held by a real one; leave it out");
}

}  // namespace

// In the order of the help.
void addRunOptions(const Command& run, RunOptions& options) {
  run.path("SCENE", options.scene, "Scene to be felt (.iv)").required();
  addArmAndHand(run, options);
  addTimes(run, options);
  addControl(run, options);
  addOutcomes(run, options);
  run.flag("--fast", options.fast, "As fast as the machine allows, and repeatable bit for bit");
  run.flag("--solid", options.solid,
           "Make a scene that is only seen felt: adds a ball and a surface of its size; the file stays as it is");
  run.json(options.json);
}

bool isLedBySpaceMouse(const RunOptions& options) {
  return spaceMouseNamed(options.hand).has_value();
}

bool isOnDevice(const RunOptions& options) {
  return isFalcon(options.device) || isBoard(options.device);
}

void refuseContradictions(const RunOptions& options) {
  refuseWhatIsNotThere(options);
  refuseWhatNoPersonCanDo(options);
}

}  // namespace haptiv
