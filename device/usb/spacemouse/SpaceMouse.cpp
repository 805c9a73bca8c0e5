#include "device/usb/spacemouse/SpaceMouse.h"

#include <chrono>

#include "device/realtime/TripleBuffer.h"
#include "device/usb/libusb/UsbLink.h"
#include "device/usb/spacemouse/SpaceMouseModels.h"
#include "device/usb/spacemouse/SpaceMouseReport.h"

namespace haptiv {
namespace {

constexpr std::uint8_t kReports = 0x81;  // endpoint

/// The link's side.
class Client : public usb::UsbClient {
 public:
  usb::StreamEndpoints prepare(usb::UsbHandle& handle) override {
    state_.connected = true;
    states.write(state_);
    return {usb::TransferKind::interrupt, kReports, static_cast<std::size_t>(handle.maxPacketSize(kReports)), 0, 0};
  }
  void received(std::span<const std::uint8_t> report) noexcept override {
    takeReport(report, std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1), state_);
    states.write(state_);
  }
  void faulted(usb::TransferEnd) noexcept override { ++state_.ignored; }
  std::size_t send(std::span<std::uint8_t>) noexcept override { return 0; }
  void skip() noexcept override {}
  void lost() noexcept override {
    const SpaceMouseState before = state_;
    state_ = {};
    state_.reports = before.reports;
    state_.ignored = before.ignored;
    states.write(state_);
  }

  TripleBuffer<SpaceMouseState> states;  // link -> whoever asks

 private:
  SpaceMouseState state_;
};

}  // namespace

struct SpaceMouse::Parts {
  explicit Parts(const std::string& which) : link(spaceMouseKind(), which, client) { link.open(); }

  Client client;
  usb::UsbLink link;
};

SpaceMouse::SpaceMouse(const std::string& which) : parts_(std::make_unique<Parts>(which)) {}

SpaceMouse::~SpaceMouse() = default;

SpaceMouseState SpaceMouse::newest() {
  parts_->client.states.update();
  return parts_->client.states.read();
}

}  // namespace haptiv
