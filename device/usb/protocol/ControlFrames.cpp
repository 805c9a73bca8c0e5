#include "device/usb/protocol/ControlFrames.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptiv::usb {

namespace {

constexpr double kUnits = 1e6;  // wire units per rad/s or N m

bool printable(char c) {
  return c >= ' ' && c <= '~';
}

/// A limit as an unsigned integer of the wire; what is no number or negative becomes zero, which allows nothing.
std::uint32_t limitToWire(double limit) {
  if (!(limit > 0)) return 0;
  return static_cast<std::uint32_t>(std::min(std::round(limit * kUnits), 4294967295.));
}

std::uint32_t within32Bits(std::int64_t value) {
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(value, 0, std::numeric_limits<std::uint32_t>::max()));
}

}  // namespace

std::span<const std::uint8_t> encode(const Identity& identity, ControlBytes& out) {
  WireWriter writer(out);
  writeHead(writer, FrameType::identity);
  writer.integer(identity.firmware, 2);
  writer.integer(identity.joints, 1);
  writer.integer(identity.homed ? 1 : 0, 1);
  for (std::size_t i = 0; i < kNameSize; ++i) writer.integer(i < identity.name.size() ? identity.name[i] : 0, 1);
  writer.crc();
  return std::span(out).first(writer.size());
}

FrameFault decode(std::span<const std::uint8_t> bytes, Identity& identity) {
  const FrameFault fault = checkFrame(bytes, FrameType::identity, kIdentitySize);
  if (fault != FrameFault::none) return fault;
  WireReader in(bytes);
  in.skip(kHeadSize);
  Identity decoded;
  decoded.firmware = in.unsignedInteger<std::uint16_t>();
  decoded.joints = in.unsignedInteger<std::uint8_t>();
  const auto homed = in.unsignedInteger<std::uint8_t>();
  decoded.homed = homed == 1;
  for (std::size_t i = 0; i < kNameSize; ++i) decoded.name += static_cast<char>(in.unsignedInteger<std::uint8_t>());
  decoded.name.resize(std::min(decoded.name.find('\0'), kNameSize));
  const bool good = std::all_of(decoded.name.begin(), decoded.name.end(), printable);
  if (!good || homed > 1 || decoded.joints < 1 || decoded.joints > kJointCount) return FrameFault::content;
  identity = decoded;
  return FrameFault::none;
}

std::span<const std::uint8_t> encode(const Capabilities& capabilities, ControlBytes& out) {
  WireWriter writer(out);
  writeHead(writer, FrameType::capabilities);
  for (const double limit : capabilities.rateLimit) writer.integer(limitToWire(limit), 4);
  for (const double limit : capabilities.torqueLimit) writer.integer(limitToWire(limit), 4);
  writer.crc();
  return std::span(out).first(writer.size());
}

FrameFault decode(std::span<const std::uint8_t> bytes, Capabilities& capabilities) {
  const FrameFault fault = checkFrame(bytes, FrameType::capabilities, kCapabilitiesSize);
  if (fault != FrameFault::none) return fault;
  WireReader in(bytes);
  in.skip(kHeadSize);
  for (double& limit : capabilities.rateLimit) limit = in.unsignedInteger<std::uint32_t>() / kUnits;
  for (double& limit : capabilities.torqueLimit) limit = in.unsignedInteger<std::uint32_t>() / kUnits;
  return FrameFault::none;
}

std::span<const std::uint8_t> encode(const CircuitThresholds& thresholds, ControlBytes& out) {
  WireWriter writer(out);
  writeHead(writer, FrameType::thresholds);
  writer.integer(within32Bits(thresholds.watchdogTime), 4);
  writer.integer(within32Bits(thresholds.velocityTimeUnit), 4);
  for (const std::uint32_t count : thresholds.countThreshold) writer.integer(count, 4);
  writer.crc();
  return std::span(out).first(writer.size());
}

FrameFault decode(std::span<const std::uint8_t> bytes, CircuitThresholds& thresholds) {
  const FrameFault fault = checkFrame(bytes, FrameType::thresholds, kThresholdsSize);
  if (fault != FrameFault::none) return fault;
  WireReader in(bytes);
  in.skip(kHeadSize);
  thresholds.watchdogTime = in.unsignedInteger<std::uint32_t>();
  thresholds.velocityTimeUnit = in.unsignedInteger<std::uint32_t>();
  for (std::uint32_t& count : thresholds.countThreshold) count = in.unsignedInteger<std::uint32_t>();
  return FrameFault::none;
}

std::span<const std::uint8_t> encode(const HomeCounts& counts, ControlBytes& out) {
  WireWriter writer(out);
  writeHead(writer, FrameType::home);
  for (const std::int32_t count : counts) writer.integer(count, 4);
  writer.crc();
  return std::span(out).first(writer.size());
}

FrameFault decode(std::span<const std::uint8_t> bytes, HomeCounts& counts) {
  const FrameFault fault = checkFrame(bytes, FrameType::home, kHomeSize);
  if (fault != FrameFault::none) return fault;
  WireReader in(bytes);
  in.skip(kHeadSize);
  for (std::int32_t& count : counts) count = in.signedInteger<std::int32_t>();
  return FrameFault::none;
}

}  // namespace haptiv::usb
