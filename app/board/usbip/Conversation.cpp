#include "app/board/usbip/Conversation.h"

#include <type_traits>
#include <utility>

namespace haptiv::usbip {
namespace {

constexpr std::uint32_t kYours = 0, kTaken = 2, kNoDevice = 4;

}  // namespace

Conversation::~Conversation() {
  if (!importer_) return;
  export_.taken = false;
  export_.pipes.reset();
}

void Conversation::hangUp(std::string reproach) {
  over_ = true;
  reproach_ = std::move(reproach);
}

void Conversation::expectTaken() {
  if (outgoing_.size() <= kMostUnsent) return;
  outgoing_.clear();
  hangUp("does not take its answers");
}

void Conversation::import(const Import& request) {
  std::uint32_t status = kYours;
  if (request.busId != export_.device.busId) {
    status = kNoDevice;
  } else if (export_.taken) {
    status = kTaken;
  }
  writeImport(export_.device, status, outgoing_);
  importer_ = status == kYours;
  over_ = !importer_;
  if (importer_) {
    export_.taken = true;
    export_.pipes.reset();
  }
}

void Conversation::handle(const Request& request) {
  if (const auto* nonsense = std::get_if<Nonsense>(&request)) return hangUp(nonsense->what);
  if (std::holds_alternative<ListDevices>(request)) {
    writeDeviceList(export_.device, outgoing_);
    over_ = true;
  } else if (const auto* wanted = std::get_if<Import>(&request)) {
    import(*wanted);
  } else if (const auto* urb = std::get_if<Submit>(&request)) {
    if (!export_.pipes.submit(*urb, outgoing_)) hangUp("has more transfers waiting than a host ever has");
  } else if (const auto* unlink = std::get_if<Unlink>(&request)) {
    export_.pipes.unlink(*unlink, outgoing_);
  }
  expectTaken();
}

void Conversation::receive(std::span<const std::uint8_t> bytes) {
  if (over_) return;
  incoming_.insert(incoming_.end(), bytes.begin(), bytes.end());
  std::size_t at = 0;
  while (!over_) {
    const auto rest = std::span<const std::uint8_t>(incoming_).subspan(at);
    const Parsed next = importer_ ? parseUrb(rest) : parseOperation(rest);
    if (std::holds_alternative<Incomplete>(next.request)) break;
    at += next.size;
    handle(next.request);
  }
  incoming_.erase(incoming_.begin(), incoming_.begin() + static_cast<std::ptrdiff_t>(over_ ? incoming_.size() : at));
}

void Conversation::microframe() {
  if (!importer_ || over_) return;
  export_.pipes.microframe(outgoing_);
  expectTaken();
}

}  // namespace haptiv::usbip
