#pragma once

#include <deque>

#include "app/board/usbip/Messages.h"
#include "device/usb/virtual/VirtualBoard.h"

namespace haptiv::usbip {

/// The endpoints of an imported board: takes URBs and answers them, those of the interrupt endpoints one a microframe,
/// those of endpoint 0 at once. One importer at a time; it appends its answers to the bytes that go to the peer.
class Pipes {
 public:
  static constexpr std::size_t kMostPending = 256;  ///< URBs that wait; no host keeps more

  explicit Pipes(usb::VirtualBoard& board) : board_(board) {}

  /// False: too many wait already; the peer is none to go on with.
  bool submit(const Submit& urb, Bytes& out);
  void unlink(const Unlink& urb, Bytes& out);
  /// A microframe of the bus: one packet of each interrupt endpoint, if it is asked for.
  void microframe(Bytes& out);
  /// The importer is gone.
  void reset();
  std::size_t pending() const noexcept { return in_.size() + out_.size(); }

 private:
  struct Waiting {
    std::uint32_t sequence = 0;
    std::uint32_t length = 0;
    Bytes data;
  };
  void answerControl(const Submit& urb, Bytes& out);
  void sendState(Bytes& out);
  void takeCommand(Bytes& out);

  usb::VirtualBoard& board_;
  std::deque<Waiting> in_, out_;
  int phase_ = 0;  // microframes since the last frame of a board in full speed
};

}  // namespace haptiv::usbip
