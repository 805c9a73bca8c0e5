#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace haptiv {

/// An open socket, closed at the end.
class Socket {
 public:
  explicit Socket(int fd) noexcept : fd_(fd) {}
  Socket(Socket&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  Socket& operator=(Socket&& other) noexcept;
  ~Socket();
  int get() const noexcept { return fd_; }

 private:
  int fd_;
};

/// A TCP socket that listens at an IPv4 address; port 0 finds a free one.
/// Throws std::runtime_error, what and what to do, where the address cannot be had.
Socket listenAt(const std::string& address, std::uint16_t port);
std::uint16_t portOf(const Socket& listener);

/// A connection that waits; none: nobody, or it was lost again.
std::optional<Socket> accepted(const Socket& listener);

/// How many bytes went through without waiting; nothing: the peer is gone.
std::optional<std::size_t> received(const Socket& peer, std::span<std::uint8_t> into);
std::optional<std::size_t> sent(const Socket& peer, std::span<const std::uint8_t> bytes);

}  // namespace haptiv
