#include "tests/support/usb/UsbFile.h"

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>

#include "tests/support/usb/UsbfsShim.h"

namespace haptiv::test {

namespace {

constexpr int kPipe = 4096;  // its size, the least there is

}  // namespace

UsbFile::UsbFile() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0 || fcntl(ends[1], F_SETPIPE_SZ, kPipe) != kPipe)
    throw std::runtime_error("the bench needs pipes of a page");
  readEnd_ = ends[0];
  writeEnd_ = ends[1];
  show(false);
}

UsbFile::~UsbFile() {
  if (readEnd_ >= 0) realClose(readEnd_);
}

/// Ready: the pipe is empty, poll says that it can be written to.
void UsbFile::show(bool ready) {
  if (readEnd_ < 0 || ready == shown_) return;  // after the read end is closed, a write would be SIGPIPE
  static std::array<char, kPipe> page{};
  const ssize_t moved = ready ? read(readEnd_, page.data(), page.size()) : write(writeEnd_, page.data(), page.size());
  if (moved != kPipe) throw std::runtime_error("the bench's pipe does not hold a page");
  shown_ = ready;
}

usbdevfs_urb* UsbFile::pending(std::uint8_t endpoint) const {
  const auto at = std::find_if(pending_.begin(), pending_.end(), [&](auto* urb) { return urb->endpoint == endpoint; });
  return at == pending_.end() ? nullptr : *at;
}

bool UsbFile::isPending(const usbdevfs_urb* urb) const {
  return std::find(pending_.begin(), pending_.end(), urb) != pending_.end();
}

void UsbFile::complete(usbdevfs_urb* urb, int status) {
  const auto at = std::find(pending_.begin(), pending_.end(), urb);
  if (at != pending_.end()) pending_.erase(at);
  urb->status = status;
  done_.push_back(urb);
  show(true);
}

usbdevfs_urb* UsbFile::reap() {
  if (done_.empty()) return nullptr;
  usbdevfs_urb* urb = done_.front();
  done_.pop_front();
  if (done_.empty()) show(false);
  return urb;
}

void UsbFile::disconnect() {
  if (!connected()) return;
  while (!pending_.empty()) complete(pending_.front(), -ESHUTDOWN);
  realClose(readEnd_);
  readEnd_ = -1;
}

}  // namespace haptiv::test
