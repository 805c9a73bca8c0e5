/// The thread that lists what is plugged in, above a virtual bus and real libusb.
#include "device/usb/PluggedWatch.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// What the watch has told, for a test that waits for it.
class Heard {
 public:
  void add(const PluggedWatch::Listing& listing) {
    const std::lock_guard lock(mutex_);
    listings_.push_back(listing);
    news_.notify_all();
  }
  /// The next one, in order.
  PluggedWatch::Listing next() {
    std::unique_lock lock(mutex_);
    if (!news_.wait_for(lock, std::chrono::seconds(30), [&] { return listings_.size() > taken_; }))
      throw std::runtime_error("nothing is listed");
    return listings_[taken_++];
  }
  std::size_t untaken() {
    const std::lock_guard lock(mutex_);
    return listings_.size() - taken_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<PluggedWatch::Listing> listings_;
  std::size_t taken_ = 0;
};

class Watch : public testing::Test {
 protected:
  VirtualPort& plugBoard(const std::string& serial) {
    return bus_.plug(std::make_shared<BoardOnUsb>(loadDeviceDescription("vishard10"), serial));
  }
  void watch() {
    watch_.emplace([this](const PluggedWatch::Listing& listing) { heard_.add(listing); });
  }
  void look() { watch_->look({}); }

  VirtualBus bus_;
  Heard heard_;
  std::optional<PluggedWatch> watch_;
};

TEST_F(Watch, ListsWhenItIsAskedTo) {
  plugBoard("B-0001");
  watch();
  bus_.settle();
  EXPECT_EQ(heard_.untaken(), 0U) << "nobody has asked";
  look();
  const PluggedWatch::Listing listing = heard_.next();
  EXPECT_EQ(listing.trouble, "");
  ASSERT_THAT(listing.devices, SizeIs(1));
  EXPECT_EQ(listing.devices[0].name(), "usb:B-0001");
}

TEST_F(Watch, ListsAnewWhenSomethingIsPluggedInOrOut) {
  watch();
  look();
  EXPECT_THAT(heard_.next().devices, IsEmpty());
  VirtualPort& port = plugBoard("B-0001");
  EXPECT_THAT(heard_.next().devices, SizeIs(1));
  bus_.unplug(port);
  EXPECT_THAT(heard_.next().devices, IsEmpty());
}

TEST_F(Watch, OneThatHasStoppedAnsweringKeepsItsName) {
  VirtualPort& hangs = plugBoard("B-0001");
  plugBoard("B-0002");
  watch();
  look();
  EXPECT_THAT(heard_.next().devices, SizeIs(2));
  hangs.faults.silentControl = true;
  look();
  const PluggedWatch::Listing listing = heard_.next();
  ASSERT_THAT(listing.devices, SizeIs(2));
  EXPECT_EQ(listing.devices[0].state, PluggedState::silent);
  EXPECT_EQ(listing.devices[0].name(), "usb:B-0001");
  EXPECT_EQ(listing.devices[1].state, PluggedState::notHomed);
}

TEST_F(Watch, PausedItTouchesNothingAndMakesUpForItLater) {
  watch();
  look();
  heard_.next();
  EXPECT_TRUE(watch_->pause());
  plugBoard("B-0001");
  look();
  bus_.settle();
  EXPECT_EQ(heard_.untaken(), 0U);
  watch_->resume();
  EXPECT_THAT(heard_.next().devices, SizeIs(1));
}

TEST_F(Watch, EndsInTheMiddleOfAListing) {
  VirtualPort& port = plugBoard("B-0001");
  port.faults.silentControl = true;
  watch();
  look();
  while (!bus_.isAsked()) std::this_thread::yield();  // it waits for the answer
  EXPECT_FALSE(watch_->pause()) << "it is listing";
  watch_.reset();
  EXPECT_EQ(heard_.untaken(), 0U) << "what is not whole is not told";
}

}  // namespace
}  // namespace haptiv::test
