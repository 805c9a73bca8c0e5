#include "app/board/Sockets.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace haptiv {
namespace {

constexpr int kBacklog = 4;

[[noreturn]] void fail(const std::string& address, std::uint16_t port, const std::string& remedy) {
  throw std::runtime_error(address + ":" + std::to_string(port) + ": cannot listen there: " + std::strerror(errno) +
                           "; " + remedy);
}

bool mayComeBack() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

Socket::~Socket() {
  if (fd_ >= 0) ::close(fd_);
}

Socket listenAt(const std::string& address, std::uint16_t port) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(port);
  if (::inet_pton(AF_INET, address.c_str(), &at.sin_addr) != 1)
    throw std::runtime_error(address + " is no IPv4 address; give one, such as 127.0.0.1");
  Socket listener(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (listener.get() < 0) fail(address, port, "free some file descriptors");
  const int yes = 1;
  ::setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(listener.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0 ||
      ::listen(listener.get(), kBacklog) != 0)
    fail(address, port, "end the program that has this port (usbipd, perhaps), or choose another with --port");
  return listener;
}

std::uint16_t portOf(const Socket& listener) {
  sockaddr_in at{};
  socklen_t size = sizeof at;
  ::getsockname(listener.get(), reinterpret_cast<sockaddr*>(&at), &size);
  return ntohs(at.sin_port);
}

std::optional<Socket> accepted(const Socket& listener) {
  Socket peer(::accept4(listener.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (peer.get() < 0) return std::nullopt;
  const int yes = 1;
  ::setsockopt(peer.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);  // an answer waits for no other
  return peer;
}

std::optional<std::size_t> received(const Socket& peer, std::span<std::uint8_t> into) {
  const ssize_t count = ::recv(peer.get(), into.data(), into.size(), 0);
  if (count > 0) return static_cast<std::size_t>(count);
  return count < 0 && mayComeBack() ? std::optional<std::size_t>(0) : std::nullopt;
}

std::optional<std::size_t> sent(const Socket& peer, std::span<const std::uint8_t> bytes) {
  const ssize_t count = ::send(peer.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (count >= 0) return static_cast<std::size_t>(count);
  return mayComeBack() ? std::optional<std::size_t>(0) : std::nullopt;
}

}  // namespace haptiv
