#include "app/commands/device/BoardCommand.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "app/board/BoardServer.h"
#include "app/board/OperatorConsole.h"
#include "app/board/VhciHint.h"
#include "app/commands/ExitCode.h"
#include "app/commands/HeldSignals.h"
#include "app/commands/Report.h"
#include "app/session/hands/HandFile.h"

namespace haptiv {
namespace {

struct BoardOptions {
  std::string description = "vishard10";
  std::string bind = "127.0.0.1";
  std::string serial = "virtual-1";
  std::string hand;               // empty: nobody at the handle
  std::optional<double> seconds;  // none: until it is told to end
  int port = usbip::kDefaultPort;
  bool fullSpeed = false;
  bool unhomed = false;
  bool json = false;
};

std::unique_ptr<usb::VirtualBoard> virtualBoard(const BoardOptions& options) {
  usb::VirtualBoardSetup setup;
  setup.description = loadDeviceDescription(options.description);
  setup.form = options.fullSpeed ? usb::FrameForm::packed : usb::FrameForm::full;
  setup.serial = options.serial;
  setup.homed = !options.unhomed;
  std::unique_ptr<HandSource> hand;
  if (!options.hand.empty()) hand = std::make_unique<ScriptedHand>(readHandFile(options.hand));
  return std::make_unique<usb::VirtualBoard>(setup, std::move(hand));
}

/// What the operator has typed since the last look; nothing at the end of the input.
std::optional<std::string> typed() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, 0) <= 0) return "";
  std::array<char, 256> bytes{};
  const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count <= 0) return std::nullopt;
  return std::string(bytes.data(), static_cast<std::size_t>(count));
}

void tellNews(const usb::VirtualBoard& board, BoardNews& news, bool imported) {
  const std::string line = news.newSince(board.report(), imported);
  if (!line.empty()) std::cerr << line << "\n" << std::flush;
}

/// Serves until told to end.
void serve(const BoardOptions& options, usb::VirtualBoard& board, BoardServer& server) {
  using Clock = BoardServer::Clock;
  const HeldSignals held;
  const auto began = Clock::now();
  OperatorConsole console;
  BoardNews news;
  bool typing = true;
  for (auto looked = began;;) {
    server.turn();
    const auto now = Clock::now();
    if (now - looked < std::chrono::milliseconds(20)) continue;
    looked = now;
    if (held.pending({}) || (options.seconds && now - began > std::chrono::duration<double>(*options.seconds))) return;
    if (typing) {
      const auto words = typed();
      typing = words.has_value();
      if (typing && !console.obey(*words)) return;
      board.press(console.inputs(now - began));
    }
    tellNews(board, news, server.isImported());
    if (const std::string reproach = server.newReproach(); !reproach.empty())
      std::cerr << reproach << "; hung up on it\n";
  }
}

int serveBoard(const BoardOptions& options) {
  const auto board = virtualBoard(options);
  BoardServer server(*board, options.bind, static_cast<std::uint16_t>(options.port));
  const VhciHint hint = vhciHint(options.bind, server.port());
  Report report;
  report.add("address", options.bind);
  report.add("port", std::uint64_t{server.port()});
  report.add("serial", options.serial);
  report.add("bus_id", "1-1");
  report.add("kernel_ready", hint.ready);
  if (options.json) report.add("advice", hint.advice);
  report.print(options.json);
  std::cout << std::flush;
  std::cerr << hint.advice << "\n" << OperatorConsole::kHelp << std::flush;
  serve(options, *board, server);
  return kGood;
}

}  // namespace

void addBoardCommand(const Command& program) {
  const auto options = std::make_shared<BoardOptions>();
  const Command board =
      program.add("board", "Serve a virtual interface board with a simulated arm over USB/IP, for --device usb",
                  [options] { return serveBoard(*options); });
  board.path("DESCRIPTION", options->description, "Of the arm: a built-in name, or a file (.toml)").showDefault();
  board.count("--port", options->port, {0, 65535}, "TCP port; 0: a free one").type("N").showDefault();
  board.text("--bind", options->bind, "IPv4 address to listen at; whoever reaches it may drive the arm")
      .type("ADDRESS")
      .showDefault();
  board.text("--serial", options->serial, "The board's serial number").type("NAME").showDefault();
  board.path("--hand", options->hand, "The operator's hand: a CSV file with t,x,y,z in s and m in the device's base")
      .type("FILE.csv");
  board.number("--seconds", options->seconds, {0, 86400, true}, "How long; until Ctrl-C").type("S");
  board.flag("--full-speed", options->fullSpeed,
             "A board that knows full speed only: packed frames, one a millisecond");
  board.flag("--unhomed", options->unhomed, "As just switched on: the encoders do not know the arm's pose");
  board.json(options->json);
}

}  // namespace haptiv
