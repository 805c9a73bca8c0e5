#include "device/usb/libusb/UsbTransfer.h"

#include <libusb.h>

#include <new>

namespace haptiv::usb {

struct TransferCallback {
  static void LIBUSB_CALL call(libusb_transfer* raw) {
    auto& transfer = *static_cast<UsbTransfer*>(raw->user_data);
    transfer.inFlight_ = false;
    transfer.done_(transfer);
  }
};

UsbTransfer::UsbTransfer(UsbHandle& handle, TransferKind kind, std::uint8_t endpoint, std::size_t size,
                         std::function<void(UsbTransfer&)> done)
    : buffer_(size), done_(std::move(done)), transfer_(libusb_alloc_transfer(0)) {
  if (transfer_ == nullptr) throw std::bad_alloc();
  libusb_fill_interrupt_transfer(transfer_, handle.get(), endpoint, buffer_.data(), static_cast<int>(size),
                                 TransferCallback::call, this, 0);
  if (kind == TransferKind::bulk) transfer_->type = LIBUSB_TRANSFER_TYPE_BULK;
}

UsbTransfer::~UsbTransfer() {
  libusb_free_transfer(transfer_);
}

TransferEnd UsbTransfer::submit(std::size_t length) noexcept {
  transfer_->length = static_cast<int>(length);
  const int result = libusb_submit_transfer(transfer_);
  inFlight_ = result == LIBUSB_SUCCESS;
  if (inFlight_) return TransferEnd::done;
  return result == LIBUSB_ERROR_NO_DEVICE ? TransferEnd::gone : TransferEnd::error;
}

void UsbTransfer::cancel() noexcept {
  if (inFlight_) libusb_cancel_transfer(transfer_);
}

TransferEnd UsbTransfer::end() const noexcept {
  switch (transfer_->status) {
    case LIBUSB_TRANSFER_COMPLETED:
      return TransferEnd::done;
    case LIBUSB_TRANSFER_STALL:
      return TransferEnd::stalled;
    case LIBUSB_TRANSFER_OVERFLOW:
      return TransferEnd::tooLong;
    case LIBUSB_TRANSFER_CANCELLED:
      return TransferEnd::cancelled;
    case LIBUSB_TRANSFER_NO_DEVICE:
      return TransferEnd::gone;
    default:
      return TransferEnd::error;
  }
}

std::span<const std::uint8_t> UsbTransfer::bytes() const noexcept {
  return std::span(buffer_).first(static_cast<std::size_t>(transfer_->actual_length));
}

}  // namespace haptiv::usb
