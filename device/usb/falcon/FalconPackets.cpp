#include "device/usb/falcon/FalconPackets.h"

#include <algorithm>

namespace haptiv::falcon {
namespace {

constexpr std::uint8_t kFirst = '<', kLast = '>', kZero = 'A';
constexpr std::size_t kFlags = 13, kSpare = 14;
constexpr std::uint8_t kHomingFlag = 1, kLedFlags = kGreen | kBlue | kRed;

/// @param flags  0 to 127
Packet packetOf(const std::array<std::int16_t, 3>& numbers, unsigned flags) noexcept {
  Packet packet;
  packet.front() = kFirst;
  packet.back() = kLast;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto number = static_cast<std::uint16_t>(numbers[i / 4]);
    packet[1 + i] = static_cast<std::uint8_t>(kZero + (number >> 4 * (i % 4) & 0xF));
  }
  packet[kFlags] = static_cast<std::uint8_t>(kZero + flags);
  packet[kSpare] = kZero;
  return packet;
}

struct Content {
  std::array<std::int16_t, 3> numbers{};
  unsigned flags = 0;
};

std::optional<Content> contentOf(std::span<const std::uint8_t> bytes, unsigned mostFlags) noexcept {
  if (bytes.size() != kPacketSize || bytes.front() != kFirst || bytes.back() != kLast) return std::nullopt;
  Content content;
  for (std::size_t i = 0; i < 12; ++i) {
    const unsigned bits = bytes[1 + i] - unsigned{kZero};  // wraps beyond 15 below the zero
    if (bits > 0xF) return std::nullopt;
    std::int16_t& number = content.numbers[i / 4];
    number = static_cast<std::int16_t>(static_cast<std::uint16_t>(number) | bits << 4 * (i % 4));
  }
  content.flags = bytes[kFlags] - unsigned{kZero};
  if (content.flags > mostFlags) return std::nullopt;
  return content;
}

}  // namespace

Packet encode(const Order& order) noexcept {
  return packetOf(order.motors, (order.leds & kLedFlags) | (order.homing ? kHomingFlag : 0u));
}

Packet encode(const State& state) noexcept {
  return packetOf(state.counts, (state.buttons & 0xFu) | (state.homed & kAllHomed) << 4);
}

std::optional<State> decodeState(std::span<const std::uint8_t> bytes) noexcept {
  const auto content = contentOf(bytes, 0x7F);
  if (!content) return std::nullopt;
  return State{content->numbers, static_cast<std::uint8_t>(content->flags >> 4),
               static_cast<std::uint8_t>(content->flags & 0xF)};
}

std::optional<Order> decodeOrder(std::span<const std::uint8_t> bytes) noexcept {
  const auto content = contentOf(bytes, kLedFlags | kHomingFlag);
  if (!content) return std::nullopt;
  return Order{content->numbers, (content->flags & kHomingFlag) != 0,
               static_cast<std::uint8_t>(content->flags & kLedFlags)};
}

}  // namespace haptiv::falcon
