#include "device/usb/host/BoardRequests.h"

#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::usb {

namespace {

constexpr std::uint8_t kFromBoard = 0xc1;  // vendor request to the interface
constexpr std::uint8_t kToBoard = 0x41;
constexpr std::size_t kVersionAt = 2;

UsbRequest requestOf(std::uint8_t direction, ControlRequest request) {
  return {direction, static_cast<std::uint8_t>(request), 0, 0};
}

[[noreturn]] void refuse(const UsbHandle& board, std::span<const std::uint8_t> answer, FrameFault fault) {
  if (fault != FrameFault::version)
    throw UsbFailure(UsbTrouble::wrongDevice, board.name() + " answers what no Haptiv board does (" + describe(fault) +
                                                  "): is it another device with the same number?");
  const int version = answer[kVersionAt];
  throw UsbFailure(UsbTrouble::wrongDevice, board.name() + " speaks version " + std::to_string(version) +
                                                " of the protocol, this program " + std::to_string(kProtocolVersion) +
                                                ": update " +
                                                (version > kProtocolVersion ? "Haptiv" : "the board's firmware"));
}

template <typename Answer>
Answer ask(UsbHandle& board, ControlRequest request, const char* what) {
  const auto bytes = board.controlIn(requestOf(kFromBoard, request), kLargestControlFrame, what);
  Answer answer;
  const FrameFault fault = decode(bytes, answer);
  if (fault != FrameFault::none) refuse(board, bytes, fault);
  return answer;
}

template <typename Frame>
void tell(UsbHandle& board, ControlRequest request, const Frame& frame, const char* what) {
  ControlBytes bytes{};
  board.controlOut(requestOf(kToBoard, request), encode(frame, bytes), what);
}

}  // namespace

UsbKind boardKind() {
  return {"Haptiv interface board", {{kVendorId, kProductId}}, kBoardInterface};
}

Identity askIdentity(UsbHandle& board) {
  return ask<Identity>(board, ControlRequest::identity, "ask for the identity of");
}

Capabilities askCapabilities(UsbHandle& board) {
  return ask<Capabilities>(board, ControlRequest::capabilities, "ask for the limits of");
}

CircuitThresholds askThresholds(UsbHandle& board) {
  return ask<CircuitThresholds>(board, ControlRequest::getThresholds, "ask for the thresholds of");
}

void setThresholds(UsbHandle& board, const CircuitThresholds& thresholds) {
  tell(board, ControlRequest::setThresholds, thresholds, "set the thresholds of");
}

void setHome(UsbHandle& board, const HomeCounts& counts) {
  tell(board, ControlRequest::home, counts, "home");
}

FrameForm frameFormOf(const UsbHandle& board) {
  const int size = board.maxPacketSize(kStateEndpoint);
  if (size >= static_cast<int>(kStateSize)) return FrameForm::full;
  if (size >= static_cast<int>(kPackedStateSize)) return FrameForm::packed;
  throw UsbFailure(UsbTrouble::wrongDevice, board.name() + " has packets of " + std::to_string(size) +
                                                " bytes, too short for its state: is it another device?");
}

}  // namespace haptiv::usb
