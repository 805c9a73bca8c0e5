#pragma once

#include <chrono>
#include <list>
#include <string>

#include "app/board/Sockets.h"
#include "app/board/usbip/Conversation.h"

namespace haptiv {

/// Serves a virtual board to whoever imports it by USB/IP. One thread: the one that calls.
///
/// The board's time follows the clock, a microframe each 125 us. A server that was kept from running makes up for
/// kLongestLag at most; what is beyond is lost to the board, which stands still meanwhile.
class BoardServer {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kLongestLag{50};
  static constexpr std::size_t kMostPeers = 8;                ///< more are turned away
  static constexpr std::chrono::seconds kLongestSilence{10};  ///< of one who asks for nothing

  /// Throws as listenAt does.
  BoardServer(usb::VirtualBoard& board, const std::string& address, std::uint16_t port);

  std::uint16_t port() const { return portOf(listener_); }
  bool isImported() const noexcept { return export_.taken; }

  /// Waits for peers until the next microframe, at most kLongestWait, and does what there is to do.
  void turn();
  static constexpr std::chrono::milliseconds kLongestWait{5};

  /// What a peer was hung up on for since the last call; empty: nothing.
  std::string newReproach();

 private:
  struct Peer {
    Peer(Socket newSocket, usbip::Export& exported) : socket(std::move(newSocket)), conversation(exported) {}
    Socket socket;
    usbip::Conversation conversation;
    Clock::time_point since = Clock::now();
    bool gone = false;
  };
  void wait();
  void welcome();
  void listenTo(Peer& peer);
  void answer(Peer& peer);
  void passTime();

  usb::VirtualBoard& board_;
  usbip::Export export_;
  Socket listener_;
  std::list<Peer> peers_;
  Clock::time_point reached_ = Clock::now();  // the board's time
  std::string reproach_;
};

}  // namespace haptiv
