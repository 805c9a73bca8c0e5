#pragma once

#include <array>
#include <string>
#include <variant>

#include "app/board/usbip/NetworkBytes.h"
#include "device/usb/protocol/Descriptors.h"

/// The messages of USB/IP 1.1.1, as the kernel's Documentation/usb/usbip_protocol.rst has them. Big-endian.
namespace haptiv::usbip {

inline constexpr std::uint16_t kVersion = 0x0111;
inline constexpr int kDefaultPort = 3240;
inline constexpr std::size_t kBusIdSize = 32;
inline constexpr std::size_t kOperationSize = 8, kImportSize = kOperationSize + kBusIdSize, kUrbSize = 48;
inline constexpr std::size_t kDeviceSize = 312;
inline constexpr std::uint32_t kLargestTransfer = 65536;  ///< [bytes] of a URB; the protocol knows no limit

/// status of a URB, as negative errno.
enum class UrbStatus : std::int32_t { good = 0, stall = -32, unlinked = -104, noSuchEndpoint = -2, overflow = -75 };

/// What a peer asks for.
struct ListDevices {};
struct Import {
  std::string busId;
};
struct Submit {
  std::uint32_t sequence = 0;
  bool in = false;
  std::uint8_t endpoint = 0;            ///< without the direction
  std::uint32_t length = 0;             ///< of the buffer [bytes]
  std::array<std::uint8_t, 8> setup{};  ///< of endpoint 0
  Bytes data;                           ///< of a URB to the device
};
struct Unlink {
  std::uint32_t sequence = 0, victim = 0;
};
/// It is no USB/IP, or beyond what is served: the connection cannot go on.
struct Nonsense {
  std::string what;
};
/// Some bytes are still to come.
struct Incomplete {};

using Request = std::variant<Incomplete, Nonsense, ListDevices, Import, Submit, Unlink>;

/// What the bytes begin with, and how many of them it takes (none where incomplete).
struct Parsed {
  Request request;
  std::size_t size = 0;
};

/// Before a device is imported / after. Total: reads no byte that is not there, allocates no more than came in.
Parsed parseOperation(std::span<const std::uint8_t> bytes);
Parsed parseUrb(std::span<const std::uint8_t> bytes);

/// The device that is on offer.
struct ExportedDevice {
  std::string busId;        ///< "1-1"
  std::uint32_t speed = 3;  ///< 2: full, 3: high
  const usb::Descriptors* descriptors = nullptr;
};
inline constexpr std::uint32_t kBusNumber = 1, kDeviceNumber = 2;

/// Append the answers.
void writeDeviceList(const ExportedDevice& device, Bytes& out);
/// @param status  0: it is yours; 2: another has it; 4: there is no such device
void writeImport(const ExportedDevice& device, std::uint32_t status, Bytes& out);
/// @param taken  how many bytes of an OUT were taken
void writeOutDone(std::uint32_t sequence, UrbStatus status, std::uint32_t taken, Bytes& out);
void writeInDone(std::uint32_t sequence, UrbStatus status, std::span<const std::uint8_t> data, Bytes& out);
void writeUnlinked(std::uint32_t sequence, UrbStatus status, Bytes& out);

}  // namespace haptiv::usbip
