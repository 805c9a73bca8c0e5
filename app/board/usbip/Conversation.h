#pragma once

#include <string>

#include "app/board/usbip/Pipes.h"

namespace haptiv::usbip {

/// What stands between all the peers of a server: the board, and who has it.
struct Export {
  explicit Export(usb::VirtualBoard& board)
      : pipes(board), device{"1-1", board.form() == usb::FrameForm::full ? 3u : 2u, &board.control().descriptors()} {}

  Pipes pipes;
  ExportedDevice device;
  bool taken = false;
};

/// One peer's side of the protocol: bytes in, bytes out, no socket. A peer that sends what is no USB/IP, asks for more
/// than the server keeps, or does not take its answers is hung up on. Memory: bounded, whatever it sends.
class Conversation {
 public:
  static constexpr std::size_t kMostUnsent = 1 << 20;  ///< [bytes] that wait for the peer to take them

  explicit Conversation(Export& exported) : export_(exported) {}
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  void receive(std::span<const std::uint8_t> bytes);
  /// A microframe has gone by.
  void microframe();

  Bytes& outgoing() noexcept { return outgoing_; }
  bool isImporter() const noexcept { return importer_; }
  /// Once what is outgoing is sent, hang up.
  bool isOver() const noexcept { return over_; }
  /// Why, where it is the peer's fault.
  const std::string& reproach() const noexcept { return reproach_; }

 private:
  void handle(const Request& request);
  void import(const Import& request);
  void hangUp(std::string reproach);
  void expectTaken();

  Export& export_;
  Bytes incoming_, outgoing_;
  bool importer_ = false, over_ = false;
  std::string reproach_;
};

}  // namespace haptiv::usbip
