#include "device/usb/peripheral/StandardRequests.h"

#include <algorithm>
#include <utility>

namespace haptiv::usb {
namespace {

constexpr std::uint16_t kOnlyInterface = 0;
const ControlAnswer kStall = std::nullopt;

ControlAnswer bytes(std::span<const std::uint8_t> from) {
  return ControlAnswer{{from.begin(), from.end()}};
}
ControlAnswer done() {
  return ControlAnswer{std::vector<std::uint8_t>{}};
}

}  // namespace

StandardRequests::StandardRequests(Descriptors descriptors)
    : descriptors_(std::move(descriptors)), halted_(descriptors_.profile().endpoints.size()) {}

void StandardRequests::reset() noexcept {
  configuration_ = 0;
  std::fill(halted_.begin(), halted_.end(), false);
}

std::optional<std::size_t> StandardRequests::find(std::uint16_t address) const noexcept {
  const std::vector<UsbEndpoint>& all = descriptors_.profile().endpoints;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].address == address) return i;
  return std::nullopt;
}

bool StandardRequests::isOpen(std::uint8_t endpoint) const noexcept {
  const std::optional<std::size_t> found = find(endpoint);
  return configuration_ != 0 && found && !halted_[*found];
}

ControlAnswer StandardRequests::status(std::uint8_t recipient, std::uint16_t index) const {
  if (recipient == kToDevice) return ControlAnswer{{std::uint8_t{descriptors_.profile().selfPowered}, 0}};
  if (recipient == kToInterface && index == kOnlyInterface) return ControlAnswer{{0, 0}};
  if (recipient != kToEndpoint) return kStall;
  if ((index & 0x7f) == 0) return ControlAnswer{{0, 0}};
  const std::optional<std::size_t> endpoint = find(index);
  return endpoint ? ControlAnswer{{std::uint8_t{halted_[*endpoint]}, 0}} : kStall;
}

ControlAnswer StandardRequests::read(const SetupPacket& setup) const {
  const std::uint8_t recipient = setup.requestType & 0x7f;
  switch (static_cast<StandardRequest>(setup.request)) {
    case StandardRequest::getDescriptor: {
      const auto found = descriptors_.find(setup.value);
      return recipient == kToDevice && !found.empty() ? bytes(found) : kStall;
    }
    case StandardRequest::getConfiguration:
      return recipient == kToDevice ? ControlAnswer{{configuration_}} : kStall;
    case StandardRequest::getInterface:
      return recipient == kToInterface && setup.index == kOnlyInterface ? ControlAnswer{{0}} : kStall;
    case StandardRequest::getStatus:
      return status(recipient, setup.index);
    default:
      return kStall;
  }
}

ControlAnswer StandardRequests::change(const SetupPacket& setup) {
  switch (static_cast<StandardRequest>(setup.request)) {
    case StandardRequest::setAddress:  // the bus keeps it
      return setup.requestType == kToDevice ? done() : kStall;
    case StandardRequest::setConfiguration:
      if (setup.requestType != kToDevice || setup.value > 1) return kStall;
      reset();
      configuration_ = static_cast<std::uint8_t>(setup.value);
      return done();
    case StandardRequest::setInterface:
      if (setup.requestType != kToInterface || setup.index != kOnlyInterface || setup.value != 0) return kStall;
      std::fill(halted_.begin(), halted_.end(), false);
      return done();
    case StandardRequest::clearFeature:
    case StandardRequest::setFeature: {
      const std::optional<std::size_t> endpoint = find(setup.index);
      if (setup.requestType != kToEndpoint || setup.value != kEndpointHalt || !endpoint) return kStall;
      halted_[*endpoint] = static_cast<StandardRequest>(setup.request) == StandardRequest::setFeature;
      return done();
    }
    default:
      return kStall;
  }
}

ControlAnswer StandardRequests::answer(const SetupPacket& setup) {
  if (!setup.isStandard()) return kStall;
  return setup.isIn() ? cutTo(setup.length, read(setup)) : change(setup);
}

}  // namespace haptiv::usb
