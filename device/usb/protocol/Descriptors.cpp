#include "device/usb/protocol/Descriptors.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace haptiv::usb {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kManufacturerString = 1, kProductString = 2, kSerialString = 3;
constexpr std::uint8_t kSelfPowered = 0xc0;
constexpr std::uint8_t kHundredMilliampere = 50;  // in units of 2 mA
constexpr std::uint8_t kInterrupt = 3;            // a kind of transfer
constexpr std::uint8_t kOftenest = 1;             // bInterval: each microframe, or each frame in full speed
constexpr std::uint8_t kControlPacket = 64;       // of endpoint 0

constexpr std::uint8_t low(std::uint16_t value) {
  return static_cast<std::uint8_t>(value);
}
constexpr std::uint8_t high(std::uint16_t value) {
  return static_cast<std::uint8_t>(value >> 8);
}
constexpr std::uint8_t number(DescriptorType type) {
  return static_cast<std::uint8_t>(type);
}

Bytes device(std::uint16_t firmware) {
  return {18,
          number(DescriptorType::device),
          0x00,
          0x02,  // USB 2.0
          0,
          0,
          0,
          kControlPacket,  // the class stands in the interface
          low(kVendorId),
          high(kVendorId),
          low(kProductId),
          high(kProductId),
          low(firmware),
          high(firmware),  //
          kManufacturerString,
          kProductString,
          kSerialString,
          1};  // one configuration
}

Bytes qualifier() {
  return {10, number(DescriptorType::deviceQualifier), 0x00, 0x02, 0, 0, 0, kControlPacket, 1, 0};
}

/// Bytes of one endpoint's descriptor.
constexpr std::array<std::uint8_t, 7> endpoint(std::uint8_t address, std::uint16_t packet) {
  return {7, number(DescriptorType::endpoint), address, kInterrupt, low(packet), high(packet), kOftenest};
}

/// The one configuration, number 1, with its one interface, which has two endpoints and no alternate settings.
Bytes configuration(DescriptorType type, FrameForm form) {
  const std::array<std::uint8_t, 9> head = {9, number(type), 32, 0, 1, 1, 0, kSelfPowered, kHundredMilliampere};
  const std::array<std::uint8_t, 9> interface = {9,
                                                 number(DescriptorType::interface),
                                                 kBoardInterface,
                                                 0,
                                                 2,
                                                 kBoardClass,
                                                 kBoardSubclass,
                                                 kBoardProtocol,
                                                 kProductString};
  const auto in = endpoint(kStateEndpoint, statePacket(form));
  const auto out = endpoint(kCommandEndpoint, kCommandPacket);
  static_assert(head.size() + interface.size() + in.size() + out.size() == 32);  // wTotalLength
  Bytes all;
  for (const auto& part : {std::span<const std::uint8_t>(head), {interface}, {in}, {out}})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// In UTF-16, of ASCII.
Bytes string(const std::string& text) {
  Bytes out = {static_cast<std::uint8_t>(2 + 2 * text.size()), number(DescriptorType::string)};
  for (const char c : text) {
    out.push_back(static_cast<std::uint8_t>(c));
    out.push_back(0);
  }
  return out;
}

void expectSerial(const std::string& serial) {
  const bool printable = std::all_of(serial.begin(), serial.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (serial.empty() || serial.size() > kLongestSerial || !printable)
    throw std::runtime_error("a board's serial is 1 to 126 printable ASCII characters without blanks; choose another");
}

}  // namespace

Descriptors::Descriptors(FrameForm form, std::uint16_t firmware, const std::string& serial)
    : device_(device(firmware)), configuration_(configuration(DescriptorType::configuration, form)) {
  expectSerial(serial);
  if (form == FrameForm::full) {
    qualifier_ = qualifier();
    otherSpeed_ = configuration(DescriptorType::otherSpeedConfiguration, FrameForm::packed);
  }
  constexpr std::uint8_t kEnglish[] = {0x09, 0x04};
  strings_ = {{4, number(DescriptorType::string), kEnglish[0], kEnglish[1]},
              string("Haptiv"),
              string("Haptiv interface board"),
              string(serial)};
}

std::span<const std::uint8_t> Descriptors::find(std::uint16_t wValue) const {
  const std::uint8_t index = low(wValue);
  const auto type = static_cast<DescriptorType>(high(wValue));
  if (type == DescriptorType::string) {
    if (index >= strings_.size()) return {};
    return strings_[index];
  }
  if (index != 0) return {};
  switch (type) {
    case DescriptorType::device:
      return device_;
    case DescriptorType::configuration:
      return configuration_;
    case DescriptorType::deviceQualifier:
      return qualifier_;
    case DescriptorType::otherSpeedConfiguration:
      return otherSpeed_;
    default:
      return {};
  }
}

std::vector<std::uint8_t> Descriptors::deviceAndConfiguration() const {
  Bytes all = device_;
  all.insert(all.end(), configuration_.begin(), configuration_.end());
  return all;
}

}  // namespace haptiv::usb
