#include "device/usb/virtual/VirtualBoard.h"

#include <utility>

#include "device/usb/protocol/BoardProfile.h"

namespace haptiv::usb {
namespace {

/// The arm as its encoders see it: where they have lost their zero they stand at nought in the home pose.
DeviceDescription asBuilt(const VirtualBoardSetup& setup) {
  DeviceDescription built = setup.description;
  if (setup.homed) return built;
  built.encoders.zero.setZero();
  const PoseCounts counts = built.countsAt(built.homeAngles);
  for (std::size_t i = 0; i < counts.size(); ++i) built.encoders.zero[static_cast<int>(i)] = -double{1} * counts[i];
  return built;
}

std::string shortName(const DeviceDescription& description) {
  return description.name.substr(0, kNameSize);
}

}  // namespace

VirtualBoard::VirtualBoard(const VirtualBoardSetup& setup, std::unique_ptr<HandSource> hand)
    : VirtualBoard(setup, asBuilt(setup), std::move(hand)) {}

VirtualBoard::VirtualBoard(const VirtualBoardSetup& setup, const DeviceDescription& built,
                           std::unique_ptr<HandSource> hand)
    : setup_(setup),
      settings_(boardSettings(built)),
      arm_(built, built.homeAngles, setup.seed),
      hand_(std::move(hand)) {
  restart();
  if (setup.homed) circuit_->board.home(arm_.encoderCounts());
}

VirtualBoard::Circuit::Circuit(const BoardSettings& settings, const VirtualBoardSetup& setup)
    : board(settings),
      port(board, setup.form,
           {kFirmware, static_cast<std::uint8_t>(setup.description.jointCount()), shortName(setup.description)}),
      control(port, Descriptors(boardProfile(setup.form, kFirmware, setup.serial))) {}

void VirtualBoard::restart() {
  circuit_.emplace(settings_, setup_);
  circuit_->board.advance(now_, arm_.measure());  // it knows its wires before the bus speaks to it
}

void VirtualBoard::advance() noexcept {
  HandTarget target = hand_ ? hand_->at(1e-6 * static_cast<double>(now_)) : HandTarget{};
  if (!hand_) target.inputs = 0;
  arm_.advance(board().demand(), target, 1e-6 * kStep);
  now_ += kStep;
  BoardInputs inputs = arm_.measure();
  inputs.buttons = target.inputs | pressed_;
  circuit_->board.advance(now_, inputs);
}

}  // namespace haptiv::usb
