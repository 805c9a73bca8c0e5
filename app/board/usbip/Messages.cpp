#include "app/board/usbip/Messages.h"

#include <algorithm>

namespace haptiv::usbip {
namespace {

enum class Operation : std::uint16_t {
  requestImport = 0x8003,
  replyImport = 0x0003,
  requestList = 0x8005,
  replyList = 0x0005,
};

enum class UrbCommand : std::uint32_t { submit = 1, unlink = 2, submitted = 3, unlinked = 4 };

constexpr std::uint32_t kNotIsochronous = 0xffffffff;

void writeOperation(NetworkWriter& out, Operation operation, std::uint32_t status) {
  out.integer(kVersion, 2);
  out.integer(static_cast<std::uint16_t>(operation), 2);
  out.integer(status, 4);
}

void writeDevice(NetworkWriter& out, const ExportedDevice& device) {
  out.text("/sys/devices/virtual/haptiv/" + device.busId, 256);
  out.text(device.busId, kBusIdSize);
  out.integer(kBusNumber, 4);
  out.integer(kDeviceNumber, 4);
  out.integer(device.speed, 4);
  const auto descriptor = device.descriptors->find(0x0100);
  for (const std::size_t at : {8, 10, 12}) {  // vendor, product, version
    out.integer(descriptor[at + 1], 1);
    out.integer(descriptor[at], 1);
  }
  out.bytes(descriptor.subspan(4, 3));  // class
  out.integer(0, 1);                    // no configuration is chosen yet
  out.integer(1, 1);                    // of one
  out.integer(1, 1);                    // interface
}

void writeUrbHead(NetworkWriter& out, UrbCommand command, std::uint32_t sequence, UrbStatus status) {
  out.integer(static_cast<std::uint32_t>(command), 4);
  out.integer(sequence, 4);
  out.zeros(12);  // device, direction, endpoint: of requests only
  out.integer(static_cast<std::uint32_t>(status), 4);
}

void writeSubmitted(std::uint32_t sequence, UrbStatus status, std::uint32_t length, Bytes& bytes) {
  NetworkWriter out(bytes);
  writeUrbHead(out, UrbCommand::submitted, sequence, status);
  out.integer(length, 4);
  out.integer(0, 4);  // start frame
  out.integer(kNotIsochronous, 4);
  out.zeros(12);  // errors; padding
}

}  // namespace

Parsed parseOperation(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kOperationSize) return {Incomplete{}, 0};
  NetworkReader in(bytes);
  const std::uint32_t version = in.integer(2);
  if (version != kVersion) return {Nonsense{"speaks no USB/IP 1.1.1"}, 0};
  switch (static_cast<Operation>(in.integer(2))) {
    case Operation::requestList:
      return {ListDevices{}, kOperationSize};
    case Operation::requestImport: {
      if (bytes.size() < kImportSize) return {Incomplete{}, 0};
      const auto field = bytes.subspan(kOperationSize, kBusIdSize);
      return {Import{{field.begin(), std::find(field.begin(), field.end(), 0)}}, kImportSize};
    }
    default:
      return {Nonsense{"asks for an operation that is none"}, 0};
  }
}

Parsed parseUrb(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kUrbSize) return {Incomplete{}, 0};
  NetworkReader in(bytes);
  const auto command = static_cast<UrbCommand>(in.integer(4));
  Submit submit;
  submit.sequence = in.integer(4);
  in.integer(4);  // the device; there is one
  const std::uint32_t direction = in.integer(4), endpoint = in.integer(4);
  if (command == UrbCommand::unlink) return {Unlink{submit.sequence, in.integer(4)}, kUrbSize};
  if (command != UrbCommand::submit) return {Nonsense{"sends a command that is none"}, 0};
  in.integer(4);  // flags
  submit.length = in.integer(4);
  in.integer(4);  // start frame
  const std::uint32_t packets = in.integer(4);
  in.integer(4);  // interval
  const auto setup = in.bytes(8);
  if (direction > 1 || endpoint > 15) return {Nonsense{"names an endpoint that is none"}, 0};
  if (packets != 0 && packets != kNotIsochronous)
    return {Nonsense{"wants isochronous transfers; the board has none"}, 0};
  submit.in = direction == 1;
  submit.endpoint = static_cast<std::uint8_t>(endpoint);
  std::copy(setup.begin(), setup.end(), submit.setup.begin());
  if (submit.in) return {std::move(submit), kUrbSize};
  if (submit.length > kLargestTransfer) return {Nonsense{"sends more than 64 kB at once"}, 0};
  if (bytes.size() - kUrbSize < submit.length) return {Incomplete{}, 0};
  const auto data = in.bytes(submit.length);
  submit.data.assign(data.begin(), data.end());
  return {std::move(submit), kUrbSize + data.size()};
}

void writeDeviceList(const ExportedDevice& device, Bytes& bytes) {
  NetworkWriter out(bytes);
  writeOperation(out, Operation::replyList, 0);
  out.integer(1, 4);  // device
  writeDevice(out, device);
  out.bytes(device.descriptors->find(0x0200).subspan(9 + 5, 3));  // class of its interface
  out.integer(0, 1);
}

void writeImport(const ExportedDevice& device, std::uint32_t status, Bytes& bytes) {
  NetworkWriter out(bytes);
  writeOperation(out, Operation::replyImport, status);
  if (status == 0) writeDevice(out, device);
}

void writeOutDone(std::uint32_t sequence, UrbStatus status, std::uint32_t taken, Bytes& out) {
  writeSubmitted(sequence, status, taken, out);
}

void writeInDone(std::uint32_t sequence, UrbStatus status, std::span<const std::uint8_t> data, Bytes& out) {
  writeSubmitted(sequence, status, static_cast<std::uint32_t>(data.size()), out);
  NetworkWriter(out).bytes(data);
}

void writeUnlinked(std::uint32_t sequence, UrbStatus status, Bytes& bytes) {
  NetworkWriter out(bytes);
  writeUrbHead(out, UrbCommand::unlinked, sequence, status);
  out.zeros(24);
}

}  // namespace haptiv::usbip
