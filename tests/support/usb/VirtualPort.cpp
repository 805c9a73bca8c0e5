#include "tests/support/usb/VirtualPort.h"

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace haptiv::test {

namespace {

constexpr std::uint8_t kInDirection = 0x80;
constexpr std::size_t kSetupSize = 8;

std::span<std::uint8_t> bufferOf(const usbdevfs_urb* urb) {
  return {static_cast<std::uint8_t*>(urb->buffer), static_cast<std::size_t>(urb->buffer_length)};
}

}  // namespace

VirtualPort::VirtualPort(std::shared_ptr<VirtualUsbDevice> device, int address)
    : device_(std::move(device)), address_(address) {
  device_->powered(true);
  configure();
}

int VirtualPort::open() {
  return files_.emplace_back(std::make_unique<UsbFile>())->descriptor();
}

bool VirtualPort::close(int descriptor) {
  return std::erase_if(files_, [&](const auto& file) { return file->descriptor() == descriptor; }) > 0;
}

UsbFile* VirtualPort::fileOf(int descriptor) const {
  for (const auto& file : files_)
    if (file->descriptor() == descriptor) return file.get();
  return nullptr;
}

std::vector<int> VirtualPort::awaited() const {
  std::vector<int> all;
  for (const auto& file : files_)
    if (file->anyPending()) all.push_back(file->descriptor());
  return all;
}

int VirtualPort::claim(UsbFile& file, unsigned interface) {
  for (const auto& other : files_)
    if (other.get() != &file && other->claimed.contains(interface)) return EBUSY;
  file.claimed.insert(interface);
  return 0;
}

int VirtualPort::control(int descriptor, unsigned long request, void* argument) {
  UsbFile& file = *fileOf(descriptor);
  if (request == USBDEVFS_REAPURBNDELAY) return reap(file, argument);
  if (!plugged_) return ENODEV;
  const auto number = [&] { return *static_cast<unsigned*>(argument); };
  switch (request) {
    case USBDEVFS_GET_CAPABILITIES:
      *static_cast<std::uint32_t*>(argument) =
          USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      return 0;
    case USBDEVFS_CLAIMINTERFACE:
      return claim(file, number());
    case USBDEVFS_RELEASEINTERFACE:
      return file.claimed.erase(number()) > 0 ? 0 : EINVAL;
    case USBDEVFS_CLEAR_HALT:
      return tell(usb::kToEndpoint, usb::StandardRequest::clearFeature, usb::kEndpointHalt, number());
    case USBDEVFS_SUBMITURB:
      return submit(file, static_cast<usbdevfs_urb*>(argument));
    case USBDEVFS_DISCARDURB:
      if (!file.isPending(static_cast<usbdevfs_urb*>(argument))) return EINVAL;
      file.complete(static_cast<usbdevfs_urb*>(argument), -ENOENT);
      return 0;
    case USBDEVFS_SETCONFIGURATION:
      return tell(usb::kToDevice, usb::StandardRequest::setConfiguration, number());
    case USBDEVFS_SETINTERFACE: {
      const auto& chosen = *static_cast<usbdevfs_setinterface*>(argument);
      return tell(usb::kToInterface, usb::StandardRequest::setInterface, chosen.altsetting, chosen.interface);
    }
    case USBDEVFS_RESET:
      configure();
      return 0;
    case USBDEVFS_GETDRIVER:  // no driver of the kernel holds it
    case USBDEVFS_IOCTL:
      return ENODATA;
    default:
      return ENOTTY;
  }
}

int VirtualPort::submit(UsbFile& file, usbdevfs_urb* urb) {
  urb->actual_length = 0;
  if (urb->type != USBDEVFS_URB_TYPE_CONTROL && file.claimed.empty()) return EINVAL;
  file.submit(urb);
  if (urb->type != USBDEVFS_URB_TYPE_CONTROL || faults.silentControl) return 0;
  if (faults.leaveAtControl > 0 && --faults.leaveAtControl == 0)
    unplug();
  else
    answer(file, urb);
  return 0;
}

int VirtualPort::reap(UsbFile& file, void* argument) {
  usbdevfs_urb* urb = file.reap();
  if (urb == nullptr) return plugged_ ? EAGAIN : ENODEV;
  *static_cast<usbdevfs_urb**>(argument) = urb;
  return 0;
}

int VirtualPort::tell(std::uint8_t recipient, usb::StandardRequest request, unsigned value, unsigned index) {
  const usb::SetupPacket setup{recipient, static_cast<std::uint8_t>(request), static_cast<std::uint16_t>(value),
                               static_cast<std::uint16_t>(index), 0};
  return device_->answer(setup, {}) ? 0 : EPIPE;
}

/// The kernel chooses the only configuration that there is.
void VirtualPort::configure() {
  tell(usb::kToDevice, usb::StandardRequest::setConfiguration, 1);
}

void VirtualPort::halt(std::uint8_t endpoint) {
  tell(usb::kToEndpoint, usb::StandardRequest::setFeature, usb::kEndpointHalt, endpoint);
}

/// Control requests are answered at once: they have no place in the bus's time.
void VirtualPort::answer(UsbFile& file, usbdevfs_urb* urb) {
  const std::span<std::uint8_t> buffer = bufferOf(urb);
  const usb::SetupPacket setup = usb::decodeSetup(buffer.first<kSetupSize>());
  const std::span<std::uint8_t> data = buffer.subspan(kSetupSize);
  const usb::ControlAnswer answer = device_->answer(setup, setup.isIn() ? std::span<const std::uint8_t>() : data);
  if (!answer) return file.complete(urb, -EPIPE);
  const std::size_t length = setup.isIn() ? std::min(answer->size(), data.size()) : data.size();
  if (setup.isIn()) std::copy_n(answer->begin(), length, data.begin());
  urb->actual_length = static_cast<int>(length);
  file.complete(urb, 0);
}

void VirtualPort::tick() {
  if (!plugged_ || faults.frozen) return;
  const std::vector<usb::UsbEndpoint>& endpoints = descriptors().profile().endpoints;
  for (const usb::UsbEndpoint& endpoint : endpoints)
    if ((endpoint.address & kInDirection) == 0) tickOut(endpoint.address);
  device_->advance(interval());
  for (const usb::UsbEndpoint& endpoint : endpoints)
    if ((endpoint.address & kInDirection) != 0) tickIn(endpoint.address);
}

UsbFile* VirtualPort::waiting(std::uint8_t endpoint, usbdevfs_urb*& urb) const {
  for (const auto& file : files_)
    if ((urb = file->pending(endpoint)) != nullptr) return file.get();
  return nullptr;
}

void VirtualPort::tickOut(std::uint8_t endpoint) {
  usbdevfs_urb* urb = nullptr;
  UsbFile* file = waiting(endpoint, urb);
  if (file == nullptr || faults.holdOut || !device_->isOpen(endpoint)) return;
  if (befalls(faults.stallOut)) {
    halt(endpoint);
    return file->complete(urb, -EPIPE);
  }
  Bytes packet(bufferOf(urb).begin(), bufferOf(urb).end());
  if (!packet.empty() && befalls(faults.corruptOut)) packet[packet.size() / 2] ^= 0x10;
  if (!befalls(faults.loseOut)) device_->packetOut(endpoint, packet);
  if (befalls(faults.repeatOut)) device_->packetOut(endpoint, packet);
  urb->actual_length = urb->buffer_length;
  file->complete(urb, 0);
}

/// What comes in this interval, when the line has done what it does.
std::optional<Bytes> VirtualPort::nextPacket(std::uint8_t endpoint) {
  std::optional<Bytes> packet = std::exchange(held_, std::nullopt);
  if (packet) return packet;
  packet = device_->packetIn(endpoint);
  if (!packet) return packet;
  if (befalls(faults.lose)) return std::nullopt;
  if (befalls(faults.repeat)) held_ = packet;
  if (befalls(faults.swap)) {
    held_ = packet;
    packet = device_->packetIn(endpoint);
  }
  if (packet && !packet->empty() && befalls(faults.corrupt)) (*packet)[packet->size() / 2] ^= 0x10;
  if (packet && befalls(faults.shorten)) packet->resize(packet->size() / 2);
  if (packet && befalls(faults.lengthen)) packet->insert(packet->end(), 8, 0xaa);
  return packet;
}

void VirtualPort::tickIn(std::uint8_t endpoint) {
  usbdevfs_urb* urb = nullptr;
  UsbFile* file = waiting(endpoint, urb);
  if (file == nullptr || !device_->isOpen(endpoint)) return;
  if (befalls(faults.stallIn)) {
    halt(endpoint);
    return file->complete(urb, -EPIPE);
  }
  if (befalls(faults.damage)) return file->complete(urb, -EPROTO);
  if (befalls(faults.babble)) return file->complete(urb, -EOVERFLOW);
  if (const std::optional<Bytes> packet = nextPacket(endpoint)) bring(*file, urb, *packet);
}

void VirtualPort::bring(UsbFile& file, usbdevfs_urb* urb, const Bytes& packet) {
  const std::span<std::uint8_t> room = bufferOf(urb);
  const std::size_t length = std::min(room.size(), packet.size());
  std::copy_n(packet.begin(), length, room.begin());
  urb->actual_length = static_cast<int>(length);
  file.complete(urb, packet.size() > room.size() ? -EOVERFLOW : 0);
}

void VirtualPort::unplug() {
  plugged_ = false;
  for (const auto& file : files_) file->disconnect();
  device_->powered(false);
}

}  // namespace haptiv::test
