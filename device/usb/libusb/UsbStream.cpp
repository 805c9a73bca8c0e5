#include "device/usb/libusb/UsbStream.h"

namespace haptiv::usb {

UsbStream::UsbStream(UsbHandle& handle, const StreamEndpoints& endpoints, UsbClient& client)
    : handle_(handle), endpoints_(endpoints), client_(client), in_(static_cast<std::size_t>(endpoints.ahead)) {
  for (Slot& slot : in_)
    slot = std::make_unique<UsbTransfer>(handle, endpoints.kind, endpoints.in, endpoints.inSize,
                                         [this](UsbTransfer& transfer) { back(transfer, true); });
  if (endpoints.out == 0) return;
  for (Slot& slot : out_)
    slot = std::make_unique<UsbTransfer>(handle, endpoints.kind, endpoints.out, endpoints.outSize,
                                         [this](UsbTransfer& transfer) { back(transfer, false); });
}

void UsbStream::start() noexcept {
  for (Slot& slot : in_) listen(*slot);
}

void UsbStream::listen(UsbTransfer& transfer) noexcept {
  if (transfer.submit(transfer.size()) != TransferEnd::done) lost_ = true;
}

/// Whether the transfer may go on its way again at once.
bool UsbStream::take(const UsbTransfer& transfer, int& faults) noexcept {
  const TransferEnd end = transfer.end();
  if (end == TransferEnd::gone) lost_ = true;
  if (end == TransferEnd::done) faults = 0;
  if (end == TransferEnd::stalled || end == TransferEnd::tooLong || end == TransferEnd::error) {
    client_.faulted(end);
    if (++faults >= kMostFaults) lost_ = true;
  }
  return !lost_ && !closing_ && end != TransferEnd::stalled;
}

void UsbStream::back(UsbTransfer& transfer, bool in) noexcept {
  const bool goesOn = take(transfer, in ? inFaults_ : outFaults_);
  if (transfer.end() == TransferEnd::stalled) (in ? inStalled_ : outStalled_) = true;
  if (!in) return;
  if (transfer.end() == TransferEnd::done && !closing_) client_.received(transfer.bytes());
  if (goesOn && !inStalled_) listen(transfer);
}

bool UsbStream::send() noexcept {
  if (lost_ || closing_ || endpoints_.out == 0) return false;
  for (Slot& slot : out_) {
    if (slot->inFlight()) continue;
    const std::size_t length = outStalled_ ? 0 : client_.send(slot->buffer());
    if (length == 0) return false;
    lost_ = slot->submit(length) != TransferEnd::done;
    resting_ = endpoints_.rest.count() > 0;
    return !lost_;
  }
  client_.skip();
  return false;
}

bool UsbStream::rests() const noexcept {
  return resting_ && !client_.awaits() && !lost_ && !closing_ && !inStalled_ && !outStalled_;
}

void UsbStream::recover() noexcept {
  if (lost_ || closing_) return;
  if (outStalled_) {
    outStalled_ = false;
    if (!handle_.clearHalt(endpoints_.out)) lost_ = true;
  }
  if (!inStalled_) return;
  bool anyLeft = false;  // a halted endpoint keeps the others back
  for (const Slot& slot : in_) {
    anyLeft = anyLeft || slot->inFlight();
    slot->cancel();
  }
  if (anyLeft) return;
  inStalled_ = false;
  if (!handle_.clearHalt(endpoints_.in)) lost_ = true;
  if (!lost_) start();
}

void UsbStream::cancel() noexcept {
  closing_ = true;
  for (const Slot& slot : in_) slot->cancel();
  for (const Slot& slot : out_)
    if (slot) slot->cancel();
}

bool UsbStream::idle() const noexcept {
  for (const Slot& slot : in_)
    if (slot->inFlight()) return false;
  for (const Slot& slot : out_)
    if (slot && slot->inFlight()) return false;
  return true;
}

}  // namespace haptiv::usb
