/// Random and mutated bytes at the server's parser: it takes them, or hangs up; it neither crashes, hangs nor grows.
#include <gtest/gtest.h>

#include <random>

#include "app/board/usbip/Conversation.h"
#include "tests/board/UsbIpPeer.h"

namespace haptiv::usbip {
namespace {

using test::UsbIpWords;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(engine_() % end); }

 private:
  std::mt19937_64 engine_;
};

/// A talk as a host has it, with something wrong in it, perhaps.
Bytes talk(Dice& dice) {
  Bytes all;
  const auto say = [&all](const Bytes& bytes) { all.insert(all.end(), bytes.begin(), bytes.end()); };
  if (dice.below(10) != 0) say(UsbIpWords::import("1-1"));
  const std::uint32_t count = dice.below(12);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t length = dice.below(200);
    std::array<std::uint8_t, 8> setup{};
    for (auto& byte : setup) byte = static_cast<std::uint8_t>(dice.below(dice.below(2) != 0 ? 12 : 256));
    switch (dice.below(5)) {
      case 0:
        say(UsbIpWords::configure(i));
        break;
      case 1:
        say(UsbIpWords::urb(i, true, dice.below(3), length, setup));
        break;
      case 2:
        say(UsbIpWords::urb(i, false, dice.below(3), length, setup, Bytes(length, 0x48)));
        break;
      case 3:
        say(UsbIpWords::unlink(i, dice.below(12)));
        break;
      default:
        say(UsbIpWords::descriptor(i, static_cast<std::uint8_t>(dice.below(9)), 0, 255));
        break;
    }
  }
  for (std::uint32_t wrong = dice.below(4); wrong > 0 && !all.empty(); --wrong) {
    const std::size_t at = dice.below(static_cast<std::uint32_t>(all.size()));
    if (dice.below(3) == 0) {
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
      all[at] = static_cast<std::uint8_t>(dice.below(256));
    }
  }
  return all;
}

TEST(HostilePeer, NeitherCrashesNorFillsTheServer) {
  usb::VirtualBoard board({loadDeviceDescription("vishard10")}, nullptr);
  Export exported(board);
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    Dice dice(seed);
    Conversation peer(exported);
    Bytes bytes = talk(dice);
    if (dice.below(8) == 0) {
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(dice.below(256));
    }
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t piece = std::min<std::size_t>(1 + dice.below(100), bytes.size() - at);
      peer.receive(std::span(bytes).subspan(at, piece));
      peer.microframe();
      at += piece;
    }
    ASSERT_LE(peer.outgoing().size(), Conversation::kMostUnsent) << "seed " << seed;
    ASSERT_LE(exported.pipes.pending(), Pipes::kMostPending) << "seed " << seed;
  }
  EXPECT_FALSE(exported.taken) << "whoever had the board has left it";
  EXPECT_FALSE(board.report().driving);
}

TEST(HostilePeer, IsAnsweredByWholeMessagesOnly) {
  usb::VirtualBoard board({loadDeviceDescription("vishard10")}, nullptr);
  Export exported(board);
  int answers = 0;
  for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
    Dice dice(seed);
    Conversation peer(exported);
    peer.receive(talk(dice));
    peer.microframe();
    const Bytes& out = peer.outgoing();
    std::size_t at = 0;
    if (!out.empty())
      at = UsbIpWords::word(out, 4) == 0 && UsbIpWords::word(out, 0) == 0x01110003u ? 8 + 312 : out.size();
    for (; at < out.size(); ++answers) {
      ASSERT_LE(at + 48, out.size()) << "seed " << seed;
      const std::uint32_t command = UsbIpWords::word(out, at);
      ASSERT_TRUE(command == 3 || command == 4) << "seed " << seed;
      // An IN answer carries what it says; one to an OUT carries none, though it says how much was taken.
      const std::uint32_t length = command == 3 ? UsbIpWords::word(out, at + 24) : 0;
      const std::size_t next = at + 48;
      const bool carries = next < out.size() && UsbIpWords::word(out, next) != 3 && UsbIpWords::word(out, next) != 4;
      at = next + (carries || next + length == out.size() ? length : 0);
    }
    ASSERT_EQ(at, out.size()) << "seed " << seed;
  }
  EXPECT_GT(answers, 2'000) << "the talks come to something";
}

}  // namespace
}  // namespace haptiv::usbip
