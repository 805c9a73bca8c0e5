#include "device/usb/falcon/FalconBoot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "device/usb/falcon/FalconStream.h"
#include "tests/device/usb/falcon/VirtualFalcon.h"

namespace haptiv::falcon {
namespace {

using test::VirtualFalcon;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

/// A virtual Falcon without a bus between.
class DirectPort : public SerialPort {
 public:
  explicit DirectPort(VirtualFalcon& falcon) : falcon_(falcon) {}

  void control(std::uint8_t request, std::uint16_t value, std::uint16_t index) override {
    ASSERT_TRUE(falcon_.control(request, value, index)) << int{request} << " " << value;
  }
  void send(std::span<const std::uint8_t> bytes) override { falcon_.take(bytes); }
  Bytes receive(std::size_t count, std::chrono::milliseconds) override {
    while (come_.size() < count && falcon_.hasToTell()) {
      const Bytes packet = falcon_.tell();
      come_.insert(come_.end(), packet.begin() + Stream::kStatus, packet.end());
    }
    const auto end = come_.begin() + static_cast<std::ptrdiff_t>(std::min(count, come_.size()));
    const Bytes bytes(come_.begin(), end);
    come_.erase(come_.begin(), end);
    return bytes;
  }

 private:
  VirtualFalcon& falcon_;
  Bytes come_;
};

Bytes someFirmware(std::size_t size = 4096) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 31 + i / 256);
  return bytes;
}

class FalconBoot : public testing::Test {
 protected:
  void bootWith(const Bytes& firmware) {
    boot(port_, [&] {
      ++asked_;
      return firmware;
    });
  }
  std::string trouble(const Bytes& firmware) {
    try {
      bootWith(firmware);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  VirtualFalcon falcon_{loadDeviceDescription("falcon"), 4000};
  DirectPort port_{falcon_};
  int asked_ = 0;
};

TEST_F(FalconBoot, BringsTheFirmwareInByteForByte) {
  bootWith(someFirmware(4000));  // the last block is a short one
  EXPECT_EQ(falcon_.stage(), VirtualFalcon::Stage::running);
  EXPECT_EQ(falcon_.firmware(), someFirmware(4000));
  EXPECT_EQ(falcon_.largestMotor(), 0) << "no force meanwhile";
}

TEST_F(FalconBoot, TakesEitherOfTheLoadersAnswers) {
  falcon_.faults().longAnswer = true;
  bootWith(someFirmware(4000));
  EXPECT_EQ(falcon_.stage(), VirtualFalcon::Stage::running);
}

TEST_F(FalconBoot, LeavesAFalconAloneThatAnswersAlready) {
  bootWith(someFirmware(4000));
  bootWith(someFirmware(4000));
  EXPECT_EQ(asked_, 1) << "the file is not even read";
}

TEST_F(FalconBoot, TriesAgainAndThenSaysWhatToDo) {
  falcon_.faults().loaderSilent = 2;
  EXPECT_EQ(trouble(someFirmware(4000)), "");
  falcon_.faults() = {};
  falcon_.control(3, 0x4138, 0);  // 9600 baud and DTR: the loader is back
  falcon_.control(1, 0x0101, 0);
  falcon_.faults().loaderSilent = 3;
  EXPECT_THAT(trouble(someFirmware(4000)), HasSubstr("power supply"));
}

TEST_F(FalconBoot, SaysWhichByteOfTheFirmwareCameBackChanged) {
  falcon_.faults().echoWrongAt = 300;
  EXPECT_THAT(trouble(someFirmware(4000)), AllOf(HasSubstr("byte 256 "), HasSubstr("docs/falcon.md")));
}

TEST_F(FalconBoot, DoubtsAFileWithWhichTheFalconDoesNotAnswer) {
  falcon_.faults().firmwareDead = true;
  EXPECT_THAT(trouble(someFirmware(4000)), HasSubstr("is the file the Falcon's?"));
  EXPECT_THAT(trouble(someFirmware(2000)), HasSubstr("is the file the Falcon's?"));
}

TEST(FtdiDivisor, IsTheOneThatTheChipKnows) {
  EXPECT_EQ(ftdiDivisor(9600), (FtdiValue{0x4138, 0}));    // 312 1/2
  EXPECT_EQ(ftdiDivisor(115200), (FtdiValue{0x001a, 0}));  // 26
  EXPECT_EQ(ftdiDivisor(3'000'000), (FtdiValue{0, 0}));
  EXPECT_EQ(ftdiDivisor(2'000'000), (FtdiValue{1, 0}));
  EXPECT_EQ(ftdiDivisor(140'000), (FtdiValue{0x0015, 1}));  // 21 3/8: within 0.3 %
  EXPECT_EQ(ftdiDivisor(1'456'312), (FtdiValue{0x0002, 0}));
}

}  // namespace
}  // namespace haptiv::falcon
