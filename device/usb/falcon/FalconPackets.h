#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

/// What the Novint Falcon's firmware and the host say to each other: packets of 16 bytes, '<' first and '>' last.
/// Between them stand four bits a byte, plus 'A': three signed numbers of 16 bits, lowest four bits first, and two
/// bytes of flags. docs/falcon.md has the tables, and what of them could not be verified.
namespace haptiv::falcon {

inline constexpr std::size_t kPacketSize = 16;
using Packet = std::array<std::uint8_t, kPacketSize>;

/// What the firmware tells.
struct State {
  std::array<std::int16_t, 3> counts{};  ///< of the encoders
  std::uint8_t homed = 0;                ///< bit i: leg i has found its zero
  std::uint8_t buttons = 0;              ///< four bits, of the grip
  bool operator==(const State&) const = default;
};
inline constexpr std::uint8_t kAllHomed = 7;

enum Led : std::uint8_t { kGreen = 1u << 1, kBlue = 1u << 2, kRed = 1u << 3 };

/// What the host asks.
struct Order {
  std::array<std::int16_t, 3> motors{};
  bool homing = true;     ///< the firmware looks for the encoders' zeros, and keeps them as long as it is asked to
  std::uint8_t leds = 0;  ///< Led bits
  bool operator==(const Order&) const = default;
};

Packet encode(const Order& order) noexcept;
Packet encode(const State& state) noexcept;  ///< as the firmware does it
/// Nothing: no packet of that kind. `bytes` may be any, of any length.
std::optional<State> decodeState(std::span<const std::uint8_t> bytes) noexcept;
std::optional<Order> decodeOrder(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace haptiv::falcon
