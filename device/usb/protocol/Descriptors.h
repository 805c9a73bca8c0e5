#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace haptiv::usb {

enum class DescriptorType : std::uint8_t {
  device = 1,
  configuration = 2,
  string = 3,
  interface = 4,
  endpoint = 5,
  deviceQualifier = 6,
  otherSpeedConfiguration = 7,
};

enum class UsbSpeed { full, high };
enum class TransferType : std::uint8_t { bulk = 2, interrupt = 3 };

struct UsbEndpoint {
  std::uint8_t address = 0;  ///< with the direction in bit 7
  TransferType transfer = TransferType::interrupt;
  std::uint16_t maxPacket = 64;
  std::uint8_t interval = 1;  ///< bInterval
};

inline constexpr std::size_t kLongestString = 126;  ///< characters that a string descriptor has room for

/// What a USB 2.0 device says it is, any device that has one configuration, number 1, with one interface, number 0,
/// without alternate settings. Texts are ASCII, of kLongestString characters at most; empty: it has none.
struct UsbProfile {
  std::uint16_t vendor = 0, product = 0;
  std::uint16_t release = 0x0100;  ///< bcdDevice
  std::string manufacturer, productName, serial;
  UsbSpeed speed = UsbSpeed::high;
  bool selfPowered = false;
  std::uint8_t interfaceClass = 0xff, subclass = 0, protocol = 0;
  std::vector<UsbEndpoint> endpoints;
  std::vector<UsbEndpoint> otherSpeed;  ///< the same at its other speed; none: it knows one speed only
};

/// A profile as bytes. Thread: any.
class Descriptors {
 public:
  explicit Descriptors(UsbProfile profile);

  /// The answer to GET_DESCRIPTOR: the type stands in the upper byte of wValue, the index in the lower. None: stall.
  std::span<const std::uint8_t> find(std::uint16_t wValue) const;
  /// Device and configuration one after the other, as sysfs has them in `descriptors`.
  std::vector<std::uint8_t> deviceAndConfiguration() const;
  const UsbProfile& profile() const noexcept { return profile_; }

 private:
  UsbProfile profile_;
  std::vector<std::uint8_t> device_, configuration_, qualifier_, otherSpeed_;
  std::vector<std::vector<std::uint8_t>> strings_;
};

}  // namespace haptiv::usb
