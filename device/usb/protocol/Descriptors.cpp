#include "device/usb/protocol/Descriptors.h"

#include <initializer_list>
#include <utility>

namespace haptiv::usb {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kManufacturerString = 1, kProductString = 2, kSerialString = 3;
constexpr std::uint8_t kSelfPowered = 0xc0, kBusPowered = 0x80;
constexpr std::uint8_t kHundredMilliampere = 50;  // in units of 2 mA
constexpr std::uint8_t kControlPacket = 64;       // of endpoint 0

constexpr std::uint8_t low(std::size_t value) {
  return static_cast<std::uint8_t>(value);
}
constexpr std::uint8_t high(std::size_t value) {
  return static_cast<std::uint8_t>(value >> 8);
}
constexpr std::uint8_t number(DescriptorType type) {
  return static_cast<std::uint8_t>(type);
}

/// Where a text stands among the strings; 0: nowhere.
std::uint8_t indexOf(const std::string& text, std::uint8_t index) {
  return text.empty() ? 0 : index;
}

void append(Bytes& bytes, std::initializer_list<std::uint8_t> more) {
  for (const std::uint8_t byte : more) bytes.push_back(byte);
}

Bytes device(const UsbProfile& profile) {
  Bytes bytes = {18, number(DescriptorType::device), 0x00, 0x02};  // USB 2.0
  append(bytes, {0, 0, 0, kControlPacket});                        // the class stands in the interface
  append(bytes, {low(profile.vendor), high(profile.vendor), low(profile.product), high(profile.product)});
  append(bytes, {low(profile.release), high(profile.release)});
  append(bytes, {indexOf(profile.manufacturer, kManufacturerString), indexOf(profile.productName, kProductString),
                 indexOf(profile.serial, kSerialString)});
  append(bytes, {1});  // one configuration
  return bytes;
}

Bytes qualifier() {
  return {10, number(DescriptorType::deviceQualifier), 0x00, 0x02, 0, 0, 0, kControlPacket, 1, 0};
}

Bytes configuration(DescriptorType type, const UsbProfile& profile, const std::vector<UsbEndpoint>& endpoints) {
  const std::size_t total = 9 + 9 + 7 * endpoints.size();
  Bytes bytes = {9, number(type), low(total), high(total), 1, 1, 0};
  append(bytes, {profile.selfPowered ? kSelfPowered : kBusPowered, kHundredMilliampere});
  append(bytes, {9, number(DescriptorType::interface), 0, 0, low(endpoints.size())});
  append(bytes, {profile.interfaceClass, profile.subclass, profile.protocol});
  append(bytes, {indexOf(profile.productName, kProductString)});
  for (const UsbEndpoint& endpoint : endpoints)
    append(bytes, {7, number(DescriptorType::endpoint), endpoint.address, static_cast<std::uint8_t>(endpoint.transfer),
                   low(endpoint.maxPacket), high(endpoint.maxPacket), endpoint.interval});
  return bytes;
}

/// In UTF-16, of ASCII; none for an empty text.
Bytes string(const std::string& text) {
  if (text.empty()) return {};
  Bytes out = {low(2 + 2 * text.size()), number(DescriptorType::string)};
  for (const char c : text) append(out, {static_cast<std::uint8_t>(c), 0});
  return out;
}

}  // namespace

Descriptors::Descriptors(UsbProfile profile)
    : profile_(std::move(profile)),
      device_(device(profile_)),
      configuration_(configuration(DescriptorType::configuration, profile_, profile_.endpoints)) {
  if (!profile_.otherSpeed.empty()) {
    qualifier_ = qualifier();
    otherSpeed_ = configuration(DescriptorType::otherSpeedConfiguration, profile_, profile_.otherSpeed);
  }
  constexpr std::uint8_t kEnglish[] = {0x09, 0x04};
  strings_ = {{4, number(DescriptorType::string), kEnglish[0], kEnglish[1]},
              string(profile_.manufacturer),
              string(profile_.productName),
              string(profile_.serial)};
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
