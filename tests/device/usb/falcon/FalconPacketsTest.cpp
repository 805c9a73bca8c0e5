#include "device/usb/falcon/FalconPackets.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "device/usb/falcon/FalconStream.h"
#include "tests/support/Random.h"

namespace haptiv::falcon {
namespace {

using haptiv::test::Random;

std::int16_t anyNumber(Random& random) {
  return static_cast<std::int16_t>(random.between(-32768, 32768));
}

State anyState(Random& random) {
  return {{anyNumber(random), anyNumber(random), anyNumber(random)},
          static_cast<std::uint8_t>(random.between(0, 8)),
          static_cast<std::uint8_t>(random.between(0, 16))};
}

/// A packet of USB: the chip's status and these bytes.
std::vector<std::uint8_t> usbPacket(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint8_t> packet = {0x01, 0x60};
  packet.insert(packet.end(), bytes.begin(), bytes.end());
  return packet;
}

TEST(FalconPackets, AnOrderIsWrittenAsOthersHaveSeenIt) {
  Order order;
  order.motors = {0x1234, -1, 0};
  order.leds = kBlue;
  const Packet packet = encode(order);
  EXPECT_EQ(std::string(packet.begin(), packet.end()), "<EDCBPPPPAAAAFA>");
}

TEST(FalconPackets, ComeBackAsTheyWere) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const State state = anyState(random);
    EXPECT_EQ(decodeState(encode(state)), state);
    Order order;
    order.motors = anyState(random).counts;
    order.homing = random.between(0, 1) < 0.5;
    order.leds = static_cast<std::uint8_t>(static_cast<unsigned>(random.between(0, 8)) << 1);
    EXPECT_EQ(decodeOrder(encode(order)), order);
  }
}

TEST(FalconPackets, AnyBytesAreAPacketOrNone) {
  Random random(2);
  const Packet good = encode(State{{1, 2, 3}, kAllHomed, 5});
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<std::uint8_t> bytes(good.begin(), good.end());
    if (random.between(0, 1) < 0.2) bytes.resize(static_cast<std::size_t>(random.between(0, 40)), '<');
    if (!bytes.empty())
      bytes[static_cast<std::size_t>(random.between(0, static_cast<double>(bytes.size())))] =
          static_cast<std::uint8_t>(random.between(0, 256));
    const auto state = decodeState(bytes);
    if (state) {
      // What is taken says just what its bytes say; the spare byte says nothing.
      const Packet again = encode(*state);
      for (std::size_t k = 0; k < kPacketSize; ++k) EXPECT_TRUE(k == 14 || again[k] == bytes[k]) << k;
    } else {
      ++refused;
    }
    decodeOrder(bytes);
  }
  EXPECT_GT(refused, 10000);
}

TEST(FalconStream, FindsStatesHoweverTheBytesAreCut) {
  Random random(3);
  std::vector<std::uint8_t> bytes;
  std::vector<State> states;
  for (int i = 0; i < 200; ++i) {
    states.push_back(anyState(random));
    const Packet packet = encode(states.back());
    bytes.insert(bytes.end(), packet.begin(), packet.end());
  }
  Stream stream;
  std::size_t seen = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto size = std::min(bytes.size() - at, static_cast<std::size_t>(random.between(0, 17)));
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto found = stream.take(usbPacket({from, from + static_cast<std::ptrdiff_t>(size)}));
    if (found) {
      EXPECT_EQ(*found, states[seen++]);
    }
    at += size;
  }
  EXPECT_EQ(seen, states.size());
  EXPECT_EQ(stream.damaged(), 0u);
}

TEST(FalconStream, TakesTheStatusBytesOutOfEveryPacketOfALongTransfer) {
  std::vector<std::uint8_t> transfer;
  std::vector<std::uint8_t> bytes;
  for (std::int16_t i = 0; i < 8; ++i) {
    const Packet packet = encode(State{{i, i, i}, 0, 0});
    bytes.insert(bytes.end(), packet.begin(), packet.end());
  }
  for (std::size_t at = 0; at < bytes.size(); at += 62) {
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto packet =
        usbPacket({from, from + static_cast<std::ptrdiff_t>(std::min<std::size_t>(62, bytes.size() - at))});
    transfer.insert(transfer.end(), packet.begin(), packet.end());
  }
  Stream stream;
  const auto newest = stream.take(transfer);
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->counts[0], 7);
  EXPECT_EQ(stream.states(), 8u);
}

TEST(FalconStream, StatusAloneTellsNothing) {
  Stream stream;
  for (const std::vector<std::uint8_t>& transfer : std::vector<std::vector<std::uint8_t>>{{}, {1}, {1, 0x60}})
    EXPECT_FALSE(stream.take(transfer));
  EXPECT_EQ(stream.damaged(), 0u);
}

TEST(FalconStream, FindsTheNextStateAfterBytesThatAreLostOrWrong) {
  const Packet good = encode(State{{100, -200, 300}, kAllHomed, 1});
  for (std::size_t lost = 0; lost < kPacketSize; ++lost) {
    std::vector<std::uint8_t> bytes(good.begin(), good.end());
    bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(lost));
    for (int i = 0; i < 3; ++i) bytes.insert(bytes.end(), good.begin(), good.end());
    Stream stream;
    const auto newest = stream.take(usbPacket(bytes));
    ASSERT_TRUE(newest) << lost;
    EXPECT_EQ(*newest, (State{{100, -200, 300}, kAllHomed, 1}));
    EXPECT_GE(stream.states(), 2u);
  }
}

TEST(FalconStream, AnyBytesAreTaken) {
  Random random(4);
  Stream stream;
  for (int i = 0; i < 20000; ++i) {
    std::vector<std::uint8_t> transfer(static_cast<std::size_t>(random.between(0, 200)));
    for (auto& byte : transfer)
      byte = static_cast<std::uint8_t>(random.between(0x3a, 0x54));  // many '<', '>', 'A'..'P'
    stream.take(transfer);
  }
  const Packet good = encode(State{{1, 2, 3}, 0, 0});
  std::optional<State> newest;
  for (int i = 0; i < 2; ++i) newest = stream.take(usbPacket({good.begin(), good.end()}));
  EXPECT_EQ(newest, (State{{1, 2, 3}, 0, 0})) << "in step again within a packet";
}

}  // namespace
}  // namespace haptiv::falcon
