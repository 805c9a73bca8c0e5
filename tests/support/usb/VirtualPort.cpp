#include "tests/support/usb/VirtualPort.h"

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace haptiv::test {

namespace {

constexpr std::uint8_t kInDirection = 0x80;
constexpr std::uint8_t kTypeMask = 0x60;  // of a request: standard, class, vendor
constexpr std::size_t kSetupSize = 8;
constexpr std::uint8_t kGetDescriptor = 6;

UsbSetup setupOf(const std::uint8_t* bytes) {
  const auto word = [&](int at) { return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8); };
  return {bytes[0], bytes[1], word(2), word(4), word(6)};
}

std::span<std::uint8_t> bufferOf(const usbdevfs_urb* urb) {
  return {static_cast<std::uint8_t*>(urb->buffer), static_cast<std::size_t>(urb->buffer_length)};
}

}  // namespace

VirtualPort::VirtualPort(std::shared_ptr<VirtualUsbDevice> device, int address)
    : device_(std::move(device)), descriptors_(device_->descriptors()), address_(address) {
  device_->powered(true);
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
      halted_.erase(static_cast<std::uint8_t>(number()));
      return 0;
    case USBDEVFS_SUBMITURB:
      return submit(file, static_cast<usbdevfs_urb*>(argument));
    case USBDEVFS_DISCARDURB:
      if (!file.isPending(static_cast<usbdevfs_urb*>(argument))) return EINVAL;
      file.complete(static_cast<usbdevfs_urb*>(argument), -ENOENT);
      return 0;
    case USBDEVFS_SETCONFIGURATION:
    case USBDEVFS_SETINTERFACE:
    case USBDEVFS_RESET:
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

std::optional<Bytes> VirtualPort::standard(const UsbSetup& setup) const {
  if (setup.request != kGetDescriptor) return std::nullopt;
  Bytes bytes;
  if (setup.value >> 8 == 1) bytes = deviceDescriptor(descriptors_);
  if (setup.value >> 8 == 2) bytes = configurationDescriptor(descriptors_);
  if (setup.value >> 8 == 3) bytes = stringDescriptor(descriptors_, setup.value & 0xff);
  if (bytes.empty()) return std::nullopt;
  return bytes;
}

/// Control requests are answered at once: they have no place in the bus's time.
void VirtualPort::answer(UsbFile& file, usbdevfs_urb* urb) {
  const std::span<std::uint8_t> buffer = bufferOf(urb);
  const UsbSetup setup = setupOf(buffer.data());
  const std::span<std::uint8_t> data = buffer.subspan(kSetupSize);
  if ((setup.type & kInDirection) == 0) {
    const bool taken = device_->controlOut(setup, data);
    urb->actual_length = taken ? static_cast<int>(data.size()) : 0;
    return file.complete(urb, taken ? 0 : -EPIPE);
  }
  const std::optional<Bytes> bytes = (setup.type & kTypeMask) == 0 ? standard(setup) : device_->controlIn(setup);
  if (!bytes) return file.complete(urb, -EPIPE);
  const std::size_t length = std::min(bytes->size(), data.size());
  std::memcpy(data.data(), bytes->data(), length);
  urb->actual_length = static_cast<int>(length);
  file.complete(urb, 0);
}

void VirtualPort::tick() {
  if (!plugged_ || faults.frozen) return;
  for (const UsbEndpoint& endpoint : descriptors_.endpoints)
    if ((endpoint.address & kInDirection) == 0) tickOut(endpoint);
  device_->advance(interval());
  for (const UsbEndpoint& endpoint : descriptors_.endpoints)
    if ((endpoint.address & kInDirection) != 0) tickIn(endpoint);
}

UsbFile* VirtualPort::waiting(std::uint8_t endpoint, usbdevfs_urb*& urb) const {
  for (const auto& file : files_)
    if ((urb = file->pending(endpoint)) != nullptr) return file.get();
  return nullptr;
}

void VirtualPort::tickOut(const UsbEndpoint& endpoint) {
  usbdevfs_urb* urb = nullptr;
  UsbFile* file = waiting(endpoint.address, urb);
  if (file == nullptr || faults.holdOut || halted_.contains(endpoint.address)) return;
  if (befalls(faults.stallOut)) {
    halted_.insert(endpoint.address);
    return file->complete(urb, -EPIPE);
  }
  Bytes packet(bufferOf(urb).begin(), bufferOf(urb).end());
  if (!packet.empty() && befalls(faults.corruptOut)) packet[packet.size() / 2] ^= 0x10;
  if (!befalls(faults.loseOut)) device_->packetOut(endpoint.address, packet);
  if (befalls(faults.repeatOut)) device_->packetOut(endpoint.address, packet);
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

void VirtualPort::tickIn(const UsbEndpoint& endpoint) {
  usbdevfs_urb* urb = nullptr;
  UsbFile* file = waiting(endpoint.address, urb);
  if (file == nullptr || halted_.contains(endpoint.address)) return;
  if (befalls(faults.stallIn)) {
    halted_.insert(endpoint.address);
    return file->complete(urb, -EPIPE);
  }
  if (befalls(faults.damage)) return file->complete(urb, -EPROTO);
  if (befalls(faults.babble)) return file->complete(urb, -EOVERFLOW);
  if (const std::optional<Bytes> packet = nextPacket(endpoint.address)) bring(*file, urb, *packet);
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
