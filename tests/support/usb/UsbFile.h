#pragma once

#include <cstdint>
#include <deque>
#include <set>

struct usbdevfs_urb;

namespace haptiv::test {

/// One opening of a virtual device's node: what the kernel keeps for it. Its file descriptor is the write end of a
/// pipe, so that poll says what usbfs would: writable while there is something to reap, an error once the device is
/// gone.
class UsbFile {
 public:
  UsbFile();
  /// The descriptor itself is closed by whoever opened it.
  ~UsbFile();
  UsbFile(const UsbFile&) = delete;
  UsbFile& operator=(const UsbFile&) = delete;

  int descriptor() const { return writeEnd_; }

  void submit(usbdevfs_urb* urb) { pending_.push_back(urb); }
  /// The oldest on its way to an endpoint; null: none.
  usbdevfs_urb* pending(std::uint8_t endpoint) const;
  bool anyPending() const { return !pending_.empty(); }
  bool isPending(const usbdevfs_urb* urb) const;
  /// Is back, with the kernel's status (0 or a negative errno).
  void complete(usbdevfs_urb* urb, int status);
  /// The oldest that is back; null: none.
  usbdevfs_urb* reap();

  /// The device is gone: everything comes back, and poll tells an error.
  void disconnect();
  bool connected() const { return readEnd_ >= 0; }

  std::set<unsigned> claimed;  ///< interfaces

 private:
  void show(bool ready);

  int readEnd_ = -1, writeEnd_ = -1;
  bool shown_ = true;
  std::deque<usbdevfs_urb*> pending_, done_;
};

}  // namespace haptiv::test
