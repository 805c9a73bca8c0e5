/// The standard requests, answered for a device that is no board: bulk endpoints, bus powered, without a serial.
#include "device/usb/peripheral/StandardRequests.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace haptiv::usb {
namespace {

using testing::ElementsAre;
using testing::Optional;

constexpr std::uint8_t kIn = 0x80;

struct Device : testing::Test {
  static UsbProfile profile() {
    UsbProfile profile;
    profile.vendor = 0x0403;
    profile.product = 0xcb48;
    profile.productName = "X";
    profile.endpoints = {{0x81, TransferType::bulk, 64, 0}, {0x02, TransferType::bulk, 64, 0}};
    return profile;
  }
  ControlAnswer ask(StandardRequest request, std::uint8_t type, int value = 0, int index = 0, int length = 255) {
    return requests.answer({type, static_cast<std::uint8_t>(request), static_cast<std::uint16_t>(value),
                            static_cast<std::uint16_t>(index), static_cast<std::uint16_t>(length)});
  }

  StandardRequests requests{Descriptors(profile())};
};

TEST_F(Device, TellsWhatItIs) {
  EXPECT_THAT(ask(StandardRequest::getDescriptor, kIn, 0x0100),
              Optional(ElementsAre(18, 1, 0, 2, 0, 0, 0, 64, 0x03, 0x04, 0x48, 0xcb, 0, 1, 0, 2, 0, 1)));
  EXPECT_THAT(ask(StandardRequest::getDescriptor, kIn, 0x0200), Optional(ElementsAre(9, 2, 32, 0, 1, 1, 0, 0x80, 50,  //
                                                                                     9, 4, 0, 0, 2, 0xff, 0, 0, 2,    //
                                                                                     7, 5, 0x81, 2, 64, 0, 0,         //
                                                                                     7, 5, 0x02, 2, 64, 0, 0)));
  EXPECT_THAT(ask(StandardRequest::getDescriptor, kIn, 0x0302), Optional(ElementsAre(4, 3, 'X', 0)));
  EXPECT_THAT(ask(StandardRequest::getDescriptor, kIn, 0x0302, 0, 2), Optional(ElementsAre(4, 3)));
  EXPECT_EQ(ask(StandardRequest::getDescriptor, kIn, 0x0303), std::nullopt) << "it has no serial";
  EXPECT_EQ(ask(StandardRequest::getDescriptor, kIn, 0x0600), std::nullopt) << "nor another speed";
}

TEST_F(Device, OpensItsEndpointsWhenItIsConfigured) {
  EXPECT_FALSE(requests.isOpen(0x81));
  EXPECT_EQ(ask(StandardRequest::setConfiguration, kToDevice, 2), std::nullopt);
  EXPECT_TRUE(ask(StandardRequest::setConfiguration, kToDevice, 1));
  EXPECT_TRUE(requests.isOpen(0x81));
  EXPECT_FALSE(requests.isOpen(0x01)) << "it has no such endpoint";
  EXPECT_THAT(ask(StandardRequest::getConfiguration, kIn), Optional(ElementsAre(1)));
  requests.reset();
  EXPECT_FALSE(requests.isOpen(0x81));
}

TEST_F(Device, HaltsOneEndpointUntilItIsCleared) {
  ask(StandardRequest::setConfiguration, kToDevice, 1);
  EXPECT_TRUE(ask(StandardRequest::setFeature, kToEndpoint, kEndpointHalt, 0x02));
  EXPECT_FALSE(requests.isOpen(0x02));
  EXPECT_TRUE(requests.isOpen(0x81));
  EXPECT_THAT(ask(StandardRequest::getStatus, kIn | kToEndpoint, 0, 0x02), Optional(ElementsAre(1, 0)));
  EXPECT_TRUE(ask(StandardRequest::clearFeature, kToEndpoint, kEndpointHalt, 0x02));
  EXPECT_TRUE(requests.isOpen(0x02));
  EXPECT_EQ(ask(StandardRequest::setFeature, kToEndpoint, kEndpointHalt, 0x03), std::nullopt);
}

TEST_F(Device, StallsWhatIsNoStandardRequest) {
  EXPECT_EQ(requests.answer({0xc0, 6, 0x0100, 0, 18}), std::nullopt);
  EXPECT_EQ(requests.answer({kIn, 7, 0, 0, 18}), std::nullopt);
}

}  // namespace
}  // namespace haptiv::usb
