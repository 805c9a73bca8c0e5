#include "device/usb/ControlPipe.h"

#include <algorithm>

namespace haptiv::usb {
namespace {

/// bRequest of the standard requests.
enum class Standard : std::uint8_t {
  getStatus = 0,
  clearFeature = 1,
  setFeature = 3,
  setAddress = 5,
  getDescriptor = 6,
  getConfiguration = 8,
  setConfiguration = 9,
  getInterface = 10,
  setInterface = 11,
};

/// bmRequestType without the direction.
constexpr std::uint8_t kToDevice = 0x00, kToInterface = 0x01, kToEndpoint = 0x02, kVendorToInterface = 0x41;
constexpr std::uint8_t kIn = 0x80;
constexpr std::uint16_t kEndpointHalt = 0;
constexpr std::uint8_t kSelfPoweredStatus = 1;

std::vector<std::uint8_t> bytes(std::span<const std::uint8_t> from) {
  return {from.begin(), from.end()};
}

}  // namespace

SetupPacket decodeSetup(std::span<const std::uint8_t, 8> bytes) noexcept {
  WireReader in(bytes);
  SetupPacket setup;
  setup.requestType = in.unsignedInteger<std::uint8_t>();
  setup.request = in.unsignedInteger<std::uint8_t>();
  setup.value = in.unsignedInteger<std::uint16_t>();
  setup.index = in.unsignedInteger<std::uint16_t>();
  setup.length = in.unsignedInteger<std::uint16_t>();
  return setup;
}

void ControlPipe::reset() noexcept {
  configuration_ = 0;
  stateHalted_ = commandHalted_ = false;
}

bool* ControlPipe::haltOf(std::uint16_t endpoint) noexcept {
  if (endpoint == kStateEndpoint) return &stateHalted_;
  return endpoint == kCommandEndpoint ? &commandHalted_ : nullptr;
}

bool ControlPipe::isOpen(std::uint8_t endpoint) const noexcept {
  if (configuration_ == 0) return false;
  if (endpoint == kStateEndpoint) return !stateHalted_;
  return endpoint == kCommandEndpoint && !commandHalted_;
}

ControlPipe::Answer ControlPipe::standardIn(const SetupPacket& setup) const {
  const std::uint8_t to = setup.requestType & 0x7f;
  switch (static_cast<Standard>(setup.request)) {
    case Standard::getDescriptor: {
      const auto found = descriptors_.find(setup.value);
      if (to != kToDevice || found.empty()) return std::nullopt;
      return bytes(found);
    }
    case Standard::getConfiguration:
      return to == kToDevice ? Answer{{configuration_}} : std::nullopt;
    case Standard::getInterface:
      return to == kToInterface && setup.index == kBoardInterface ? Answer{{0}} : std::nullopt;
    case Standard::getStatus:
      if (to == kToDevice) return Answer{{kSelfPoweredStatus, 0}};
      if (to == kToInterface && setup.index == kBoardInterface) return Answer{{0, 0}};
      if (to == kToEndpoint && setup.index == kStateEndpoint) return Answer{{stateHalted_, 0}};
      if (to == kToEndpoint && setup.index == kCommandEndpoint) return Answer{{commandHalted_, 0}};
      if (to == kToEndpoint && (setup.index & 0x7f) == 0) return Answer{{0, 0}};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

ControlPipe::Answer ControlPipe::standardOut(const SetupPacket& setup) {
  const Answer done{std::vector<std::uint8_t>{}};
  switch (static_cast<Standard>(setup.request)) {
    case Standard::setAddress:  // the bus keeps it
      return setup.requestType == kToDevice ? done : std::nullopt;
    case Standard::setConfiguration:
      if (setup.requestType != kToDevice || setup.value > 1) return std::nullopt;
      reset();
      configuration_ = static_cast<std::uint8_t>(setup.value);
      return done;
    case Standard::setInterface:
      if (setup.requestType != kToInterface || setup.index != kBoardInterface || setup.value != 0) return std::nullopt;
      stateHalted_ = commandHalted_ = false;
      return done;
    case Standard::clearFeature:
    case Standard::setFeature: {
      bool* halt = setup.requestType == kToEndpoint ? haltOf(setup.index) : nullptr;
      if (halt == nullptr || setup.value != kEndpointHalt) return std::nullopt;
      *halt = static_cast<Standard>(setup.request) == Standard::setFeature;
      return done;
    }
    default:
      return std::nullopt;
  }
}

ControlPipe::Answer ControlPipe::vendor(const SetupPacket& setup, std::span<const std::uint8_t> data) {
  if (setup.value != 0 || setup.index != kBoardInterface) return std::nullopt;
  if (!setup.isIn()) return port_.controlOut(setup.request, data) ? Answer{std::vector<std::uint8_t>{}} : std::nullopt;
  ControlBytes out{};
  const auto found = port_.controlIn(setup.request, out);
  return found.empty() ? std::nullopt : Answer{bytes(found)};
}

ControlPipe::Answer ControlPipe::answer(const SetupPacket& setup, std::span<const std::uint8_t> data) {
  Answer answer;
  if ((setup.requestType & ~kIn) == kVendorToInterface) {
    answer = vendor(setup, data);
  } else if ((setup.requestType & 0x60) == 0) {
    answer = setup.isIn() ? standardIn(setup) : standardOut(setup);
  }
  if (answer && answer->size() > setup.length) answer->resize(setup.length);
  return answer;
}

}  // namespace haptiv::usb
