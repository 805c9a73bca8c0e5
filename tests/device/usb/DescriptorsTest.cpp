/// The board's descriptors, byte for byte as docs/usb-protocol.md has them.
#include "device/usb/protocol/BoardProfile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace haptiv::usb {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

constexpr std::uint16_t kDevice = 0x0100, kConfiguration = 0x0200, kString = 0x0300;

Descriptors described(FrameForm form, std::uint16_t firmware, const std::string& serial) {
  return Descriptors(boardProfile(form, firmware, serial));
}

std::string textOf(std::span<const std::uint8_t> string) {
  std::string text;
  for (std::size_t i = 2; i + 1 < string.size(); i += 2) text += static_cast<char>(string[i]);
  return text;
}

TEST(Descriptors, NameTheBoard) {
  const Descriptors board = described(FrameForm::full, 0x0102, "A-17");
  EXPECT_THAT(board.find(kDevice),
              ElementsAre(18, 1, 0, 2, 0, 0, 0, 64, 0x09, 0x12, 0x01, 0x00, 0x02, 0x01, 1, 2, 3, 1));
  EXPECT_THAT(board.find(kString), ElementsAre(4, 3, 0x09, 0x04));
  EXPECT_EQ(textOf(board.find(kString | 1)), "Haptiv");
  EXPECT_EQ(textOf(board.find(kString | 2)), "Haptiv interface board");
  EXPECT_EQ(textOf(board.find(kString | 3)), "A-17");
  EXPECT_EQ(board.find(kString | 3)[0], 2 + 2 * 4);
}

TEST(Descriptors, HaveOneInterfaceWithTwoInterruptEndpoints) {
  const Descriptors board = described(FrameForm::full, 0x0100, "1");
  EXPECT_THAT(board.find(kConfiguration), ElementsAre(9, 2, 32, 0, 1, 1, 0, 0xc0, 50,      //
                                                      9, 4, 0, 0, 2, 0xff, 0x48, 0x01, 2,  //
                                                      7, 5, 0x81, 3, 128, 0, 1,            //
                                                      7, 5, 0x01, 3, 64, 0, 1));
  EXPECT_THAT(board.deviceAndConfiguration(), testing::SizeIs(18 + 32));
}

TEST(Descriptors, TellFullSpeedByTheInPacket) {
  const Descriptors high = described(FrameForm::full, 0x0100, "1"), full = described(FrameForm::packed, 0x0100, "1");
  EXPECT_EQ(high.find(kConfiguration)[18 + 4], 128);
  EXPECT_EQ(full.find(kConfiguration)[18 + 4], 64);
  EXPECT_GE(statePacket(FrameForm::full), stateSize(FrameForm::full));
  EXPECT_GE(statePacket(FrameForm::packed), stateSize(FrameForm::packed));
  EXPECT_GE(kCommandPacket, commandSize(FrameForm::full));
}

TEST(Descriptors, OfTheOtherSpeedExistInHighSpeedOnly) {
  const Descriptors high = described(FrameForm::full, 0x0100, "1"), full = described(FrameForm::packed, 0x0100, "1");
  EXPECT_THAT(high.find(0x0600), ElementsAre(10, 6, 0, 2, 0, 0, 0, 64, 1, 0));
  EXPECT_EQ(high.find(0x0700)[1], 7);
  EXPECT_EQ(high.find(0x0700)[18 + 4], 64);
  EXPECT_THAT(full.find(0x0600), IsEmpty());
  EXPECT_THAT(full.find(0x0700), IsEmpty());
}

TEST(Descriptors, ThatDoNotExistStall) {
  const Descriptors board = described(FrameForm::full, 0x0100, "1");
  for (const int wValue : {0x0000, 0x0101, 0x0201, 0x0304, 0x03ff, 0x0400, 0x0500, 0x0800, 0xffff})
    EXPECT_THAT(board.find(static_cast<std::uint16_t>(wValue)), IsEmpty()) << wValue;
}

TEST(Descriptors, WantASerialThatFitsOneStringDescriptor) {
  EXPECT_NO_THROW(described(FrameForm::full, 0x0100, std::string(126, 's')));
  EXPECT_EQ(described(FrameForm::full, 0x0100, std::string(126, 's')).find(kString | 3).size(), 254u);
  for (const std::string& bad : {std::string(), std::string(127, 's'), std::string("a b"), std::string("\x1b[2J")})
    EXPECT_THROW(described(FrameForm::full, 0x0100, bad), std::runtime_error) << bad;
}

}  // namespace
}  // namespace haptiv::usb
