#include "device/usb/protocol/BoardProfile.h"

#include <algorithm>
#include <stdexcept>

namespace haptiv::usb {
namespace {

constexpr std::uint8_t kOftenest = 1;  // bInterval: each microframe, or each frame in full speed

std::vector<UsbEndpoint> endpoints(FrameForm form) {
  return {{kStateEndpoint, TransferType::interrupt, statePacket(form), kOftenest},
          {kCommandEndpoint, TransferType::interrupt, kCommandPacket, kOftenest}};
}

void expectSerial(const std::string& serial) {
  const bool printable = std::all_of(serial.begin(), serial.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (serial.empty() || serial.size() > kLongestString || !printable)
    throw std::runtime_error("a board's serial is 1 to 126 printable ASCII characters without blanks; choose another");
}

}  // namespace

UsbProfile boardProfile(FrameForm form, std::uint16_t firmware, const std::string& serial) {
  expectSerial(serial);
  UsbProfile board;
  board.vendor = kVendorId;
  board.product = kProductId;
  board.release = firmware;
  board.manufacturer = "Haptiv";
  board.productName = "Haptiv interface board";
  board.serial = serial;
  board.speed = form == FrameForm::full ? UsbSpeed::high : UsbSpeed::full;
  board.selfPowered = true;
  board.interfaceClass = kBoardClass;
  board.subclass = kBoardSubclass;
  board.protocol = kBoardProtocol;
  board.endpoints = endpoints(form);
  if (form == FrameForm::full) board.otherSpeed = endpoints(FrameForm::packed);
  return board;
}

}  // namespace haptiv::usb
