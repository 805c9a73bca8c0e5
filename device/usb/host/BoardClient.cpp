#include "device/usb/host/BoardClient.h"

#include "device/usb/host/StatePace.h"
#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::usb {

BoardClient::BoardClient(const DeviceDescription& description) : description_(description) {}

void BoardClient::expectThisArm(const UsbHandle& handle, const Identity& identity) const {
  const std::string wanted = description_.name.substr(0, kNameSize);
  if (identity.name == wanted && identity.joints == description_.jointCount()) return;
  throw UsbFailure(UsbTrouble::wrongDevice,
                   handle.name() + " drives the arm '" + identity.name + "' of " + std::to_string(identity.joints) +
                       " joints, the scene asks for '" + wanted + "' of " + std::to_string(description_.jointCount()) +
                       ": choose the description that belongs to the board (HapticDevice, description)");
}

StreamEndpoints BoardClient::prepare(UsbHandle& handle) {
  const Identity identity = askIdentity(handle);
  expectThisArm(handle, identity);
  form_ = frameFormOf(handle);
  // The board keeps to its own thresholds where the description's are looser.
  const CircuitThresholds wanted = boardSettings(description_).thresholds;
  if (noLooser(wanted, askThresholds(handle))) setThresholds(handle, wanted);
  if (home_ && !identity.homed) setHome(handle, *home_);
  const bool isHomed = identity.homed || home_.has_value();
  home_.reset();
  intake_.begin(form_);
  outlet_.begin(form_);
  phase_ = isHomed ? BoardPhase::ready : BoardPhase::unhomed;
  const StatePace pace = statePace(period_, form_);
  return {TransferKind::interrupt,
          kStateEndpoint,
          static_cast<std::size_t>(handle.maxPacketSize(kStateEndpoint)),
          kCommandEndpoint,
          kLargestFrame,
          pace.ahead,
          pace.rest};
}

void BoardClient::received(std::span<const std::uint8_t> packet) noexcept {
  if (intake_.take(packet)) outlet_.echoed(intake_.last().report.lastSequence);
}

void BoardClient::faulted(TransferEnd end) noexcept {
  if (end == TransferEnd::stalled) ++counters_.stalls;
  if (end == TransferEnd::tooLong) ++counters_.tooLong;
  if (end == TransferEnd::error) ++counters_.errors;
}

/// Nothing before the first state: it tells from which number on the board accepts commands.
std::size_t BoardClient::send(std::span<std::uint8_t> packet) noexcept {
  if (!intake_.any()) return 0;
  return outlet_.packet(packet, intake_.last().report.lastSequence);
}

void BoardClient::lost() noexcept {
  phase_ = BoardPhase::absent;
  ++counters_.losses;
}

}  // namespace haptiv::usb
