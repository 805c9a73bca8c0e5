#pragma once

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <utility>

#include "device/usb/falcon/FalconDevice.h"
#include "device/usb/peripheral/StandardRequests.h"
#include "tests/device/usb/falcon/VirtualFalcon.h"
#include "tests/support/usb/RunningBus.h"

namespace haptiv::falcon::test {

using haptiv::test::Bytes;

/// A VirtualFalcon as a USB device of full speed: an interval of the bus is a millisecond.
class FalconOnUsb : public haptiv::test::VirtualUsbDevice {
 public:
  explicit FalconOnUsb(const DeviceDescription& description) : falcon(description) {}

  const usb::Descriptors& descriptors() const override { return standard_.descriptors(); }
  usb::ControlAnswer answer(const usb::SetupPacket& setup, std::span<const std::uint8_t>) override {
    if (setup.isStandard()) return standard_.answer(setup);
    const bool taken = setup.requestType == 0x40 && falcon.control(setup.request, setup.value, setup.index);
    return taken ? usb::ControlAnswer{Bytes{}} : std::nullopt;
  }
  bool isOpen(std::uint8_t endpoint) const override { return standard_.isOpen(endpoint); }
  std::optional<Bytes> packetIn(std::uint8_t) override { return falcon.tell(); }
  void packetOut(std::uint8_t, std::span<const std::uint8_t> packet) override { falcon.take(packet); }
  void advance(std::int64_t) override {}

  VirtualFalcon falcon;

 private:
  static usb::UsbProfile profile() {
    constexpr auto kBulk = usb::TransferType::bulk;
    usb::UsbProfile profile;
    profile.vendor = 0x0403;
    profile.product = 0xcb48;
    profile.manufacturer = "FTDI";
    profile.productName = "FALCON HAPTIC";
    profile.serial = "FALCON-1";
    profile.speed = usb::UsbSpeed::full;
    profile.subclass = profile.protocol = 0xff;
    profile.endpoints = {{0x81, kBulk, 64, 0}, {0x02, kBulk, 64, 0}};
    return profile;
  }

  usb::StandardRequests standard_{usb::Descriptors(profile())};
};

/// A FalconDevice over the virtual bus, whose clock is the servo's: each write lets a millisecond pass on the bus. A
/// start begins anew, with a Falcon that has just been plugged in, has no firmware, and homes by itself. The operator
/// holds the dead-man from the first write on.
class BenchedFalcon : public HapticDevice {
 public:
  explicit BenchedFalcon(const DeviceDescription& description) : description_(description) {
    std::ofstream(firmware_, std::ios::binary) << std::string(4096, '\x7f');
  }
  ~BenchedFalcon() override {
    device_.reset();
    std::filesystem::remove(firmware_);
  }

  /// Sets the bus going by itself meanwhile: the set-up waits for answers.
  template <typename Work>
  void whileTheBusRuns(const Work& work) {
    const haptiv::test::RunningBus runs(bus_, std::chrono::microseconds(100));
    work();
  }

  void start(double period) override {
    if (!running_) plug();
    if (!device_) device_ = std::make_unique<FalconDevice>(description_, choice());
    whileTheBusRuns([&] { device_->start(period); });
    bus_.tick(3);
    running_ = true;
  }
  DeviceReading read() noexcept override { return device_ ? device_->read() : DeviceReading{}; }
  void write(const DeviceCommand& command) noexcept override {
    if (!running_) return;
    falcon().setButtons(buttons);
    device_->read();
    device_->write(command);
    bus_.tick();
  }
  void stop() override {
    if (!running_) return;
    whileTheBusRuns([&] { device_->stop(); });
    falcon().setButtons(0);
    running_ = false;
  }

  void plug() {
    if (port_ != nullptr) bus_.unplug(*port_);
    usb_ = std::make_shared<FalconOnUsb>(description_);
    if (beforePlugging) beforePlugging(usb_->falcon);
    port_ = &bus_.plug(usb_);
  }
  void loseFirmwareFile() { std::filesystem::remove(firmware_); }
  void unplug() { bus_.unplug(*std::exchange(port_, nullptr)); }

  VirtualFalcon& falcon() { return usb_->falcon; }
  FalconDevice& device() { return *device_; }
  haptiv::test::VirtualPort& port() { return *port_; }
  haptiv::test::VirtualBus& bus() { return bus_; }

  std::uint8_t buttons = Logic::kDeadManButton;
  std::function<void(VirtualFalcon&)> beforePlugging;  ///< to make it another one
  std::function<void(const std::string&)> tell;        ///< gets what the operator is told
  std::chrono::seconds homingTime{30};
  std::function<bool()> cancelled;  ///< whether homing is given up

 private:
  FalconChoice choice() const {
    FalconChoice choice;
    choice.firmware = firmware_;
    choice.tell = tell;
    choice.homingTime = homingTime;
    choice.cancelled = cancelled;
    return choice;
  }

  DeviceDescription description_;
  std::filesystem::path firmware_ =
      std::filesystem::temp_directory_path() / ("haptiv-falcon-" + std::to_string(::getpid()) + ".bin");
  haptiv::test::VirtualBus bus_;
  std::shared_ptr<FalconOnUsb> usb_;
  haptiv::test::VirtualPort* port_ = nullptr;
  std::unique_ptr<FalconDevice> device_;
  bool running_ = false;
};

}  // namespace haptiv::falcon::test
