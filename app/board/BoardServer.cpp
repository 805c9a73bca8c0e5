#include "app/board/BoardServer.h"

#include <poll.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace haptiv {
namespace {

constexpr std::chrono::microseconds kMicroframe{usb::VirtualBoard::kStep};

}  // namespace

BoardServer::BoardServer(usb::VirtualBoard& board, const std::string& address, std::uint16_t port)
    : board_(board), export_(board), listener_(listenAt(address, port)) {}

std::string BoardServer::newReproach() {
  return std::exchange(reproach_, {});
}

void BoardServer::wait() {
  std::vector<pollfd> watched{{listener_.get(), POLLIN, 0}};
  for (const Peer& peer : peers_) watched.push_back({peer.socket.get(), POLLIN, 0});
  // A host that waits for a packet gets it with the next microframe.
  const std::chrono::nanoseconds longest =
      export_.pipes.pending() > 0 ? std::chrono::nanoseconds(kMicroframe) : kLongestWait;
  const timespec most{0, static_cast<long>(longest.count())};
  ::ppoll(watched.data(), watched.size(), &most, nullptr);
}

void BoardServer::welcome() {
  while (auto socket = accepted(listener_)) {
    if (peers_.size() < kMostPeers) peers_.emplace_back(std::move(*socket), export_);
  }
}

void BoardServer::listenTo(Peer& peer) {
  std::array<std::uint8_t, 16384> bytes;
  const auto count = received(peer.socket, bytes);
  if (!count) {
    peer.gone = true;
    return;
  }
  if (!peer.conversation.isImporter() && Clock::now() - peer.since > kLongestSilence) peer.gone = true;
  peer.conversation.receive(std::span(bytes).first(*count));
}

void BoardServer::answer(Peer& peer) {
  usbip::Bytes& out = peer.conversation.outgoing();
  if (!out.empty()) {
    const auto count = sent(peer.socket, out);
    if (!count) peer.gone = true;
    out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count.value_or(out.size())));
  }
  if (!peer.conversation.isOver() || !out.empty()) return;
  peer.gone = true;
  if (!peer.conversation.reproach().empty()) reproach_ = "a peer " + peer.conversation.reproach();
}

void BoardServer::passTime() {
  const auto now = Clock::now();
  reached_ = std::max(reached_, now - kLongestLag);
  for (; reached_ + kMicroframe <= now; reached_ += kMicroframe) {
    board_.advance();
    for (Peer& peer : peers_) peer.conversation.microframe();
  }
}

void BoardServer::turn() {
  wait();
  welcome();
  for (Peer& peer : peers_) listenTo(peer);
  passTime();
  for (Peer& peer : peers_) answer(peer);
  peers_.remove_if([](const Peer& peer) { return peer.gone; });
}

}  // namespace haptiv
