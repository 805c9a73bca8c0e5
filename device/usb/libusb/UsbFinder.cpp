#include "device/usb/libusb/UsbFinder.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "device/usb/libusb/SideBySide.h"
#include "device/usb/libusb/UsbText.h"

namespace haptiv::usb {

namespace {

/// "1-4.2"; the bus alone where libusb does not know the port.
std::string portOf(libusb_device* device) {
  std::array<std::uint8_t, 7> ports{};  // USB has no more hubs in a row
  const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  std::string text = std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < count; ++i) text += (i == 0 ? "-" : ".") + std::to_string(ports[static_cast<std::size_t>(i)]);
  return text;
}

void readTexts(FoundUsb& found, const UsbKind& kind) {
  libusb_device_descriptor descriptor{};
  libusb_get_device_descriptor(found.device.get(), &descriptor);
  libusb_device_handle* handle = nullptr;
  const int opened = libusb_open(found.device.get(), &handle);
  if (opened < 0) {
    found.trouble = failureOf(opened, "open", found.describedAs(kind));
    return;
  }
  try {
    found.serial = textOf(handle, descriptor.iSerialNumber);
    found.product = textOf(handle, descriptor.iProduct);
  } catch (const SilentDevice&) {
    found.trouble = failureOf(LIBUSB_ERROR_TIMEOUT, "ask for the name of", found.describedAs(kind));
  }
  libusb_close(handle);
}

std::optional<FoundUsb> look(libusb_device* device, const UsbKind& kind) {
  libusb_device_descriptor descriptor{};
  if (libusb_get_device_descriptor(device, &descriptor) < 0) return std::nullopt;
  FoundUsb found;
  found.id = {descriptor.idVendor, descriptor.idProduct};
  if (std::find(kind.ids.begin(), kind.ids.end(), found.id) == kind.ids.end()) return std::nullopt;
  found.bus = libusb_get_bus_number(device);
  found.address = libusb_get_device_address(device);
  found.port = portOf(device);
  found.highSpeed = libusb_get_device_speed(device) >= LIBUSB_SPEED_HIGH;
  found.device = {libusb_ref_device(device), libusb_unref_device};
  return found;
}

std::string namesOf(const std::vector<FoundUsb>& these, const std::vector<FoundUsb>& all) {
  std::string text;
  for (const FoundUsb& found : these) text += (text.empty() ? "" : ", ") + nameAmong(all, found);
  return text;
}

/// A serial number comes first: it is the same in every port.
std::vector<FoundUsb> thoseMeant(const std::vector<FoundUsb>& all, const std::string& which) {
  if (which.empty()) return all;
  std::vector<FoundUsb> meant;
  for (const FoundUsb& found : all)
    if (found.serial == which) meant.push_back(found);
  if (!meant.empty()) return meant;
  for (const FoundUsb& found : all)
    if (found.port == which) meant.push_back(found);
  return meant;
}

}  // namespace

std::string FoundUsb::describedAs(const UsbKind& kind) const {
  return "the " + kind.name + (serial.empty() ? "" : " " + serial) + " at bus " + std::to_string(bus) + ", device " +
         std::to_string(address);
}

std::vector<FoundUsb> findUsb(const UsbContext& context, const UsbKind& kind) {
  libusb_device** list = nullptr;
  const auto count = libusb_get_device_list(context.get(), &list);
  expectUsb(static_cast<int>(count), "list", "USB devices");
  std::vector<FoundUsb> all;
  for (ssize_t i = 0; i < count; ++i)
    if (std::optional<FoundUsb> found = look(list[i], kind)) all.push_back(std::move(*found));
  libusb_free_device_list(list, 1);
  sideBySide(all, [&](FoundUsb& found) { readTexts(found, kind); });
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return std::tie(a.bus, a.address) < std::tie(b.bus, b.address); });
  return all;
}

std::string nameAmong(const std::vector<FoundUsb>& all, const FoundUsb& one) {
  const auto same = std::count_if(all.begin(), all.end(), [&](const auto& each) { return each.serial == one.serial; });
  return one.serial.empty() || same > 1 ? one.port : one.serial;
}

FoundUsb findOne(const UsbContext& context, const UsbKind& kind, const std::string& which) {
  const std::vector<FoundUsb> all = findUsb(context, kind);
  if (all.empty())
    throw UsbFailure(UsbTrouble::notFound, "there is no " + kind.name + ": plug one in and switch it on");
  const std::vector<FoundUsb> meant = thoseMeant(all, which);
  if (meant.size() == 1 && !meant.front().trouble) return meant.front();
  for (const FoundUsb& found : meant.empty() ? all : meant)
    if (found.trouble) throw *found.trouble;
  if (meant.empty())
    throw UsbFailure(UsbTrouble::notFound, "there is no " + kind.name + " with the serial number or at the port " +
                                               which + "; there is: " + namesOf(all, all) + ". Choose one of these");
  throw UsbFailure(UsbTrouble::ambiguous, "there are several of the kind " + kind.name +
                                              ": choose one, by its serial number or port: " + namesOf(meant, all));
}

}  // namespace haptiv::usb
