#include "device/usb/peripheral/ControlPipe.h"

#include "device/usb/protocol/BoardProfile.h"

namespace haptiv::usb {
namespace {

constexpr std::uint8_t kVendorToInterface = 0x41, kVendorFromInterface = 0xc1;  // bmRequestType

}  // namespace

ControlAnswer ControlPipe::vendor(const SetupPacket& setup, std::span<const std::uint8_t> data) {
  if (setup.value != 0 || setup.index != kBoardInterface) return std::nullopt;
  if (setup.requestType == kVendorToInterface)
    return port_.controlOut(setup.request, data) ? ControlAnswer{std::vector<std::uint8_t>{}} : std::nullopt;
  if (setup.requestType != kVendorFromInterface) return std::nullopt;
  ControlBytes out{};
  const auto found = port_.controlIn(setup.request, out);
  if (found.empty()) return std::nullopt;
  return cutTo(setup.length, ControlAnswer{{found.begin(), found.end()}});
}

ControlAnswer ControlPipe::answer(const SetupPacket& setup, std::span<const std::uint8_t> data) {
  return setup.isStandard() ? standard_.answer(setup) : vendor(setup, data);
}

}  // namespace haptiv::usb
