/// The server over a real loopback socket, in the thread that also plays the host.
#include "app/board/BoardServer.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <stdexcept>

#include "tests/board/UsbIpPeer.h"
#include "tests/device/usb/FrameSamples.h"

namespace haptiv {
namespace {

using test::UsbIpWords;
using testing::HasSubstr;
using usbip::Bytes;

Socket connectedTo(std::uint16_t port) {
  Socket socket(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(port);
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::connect(socket.get(), reinterpret_cast<sockaddr*>(&at), sizeof at), 0);
  return socket;
}

struct Served : testing::Test {
  usb::VirtualBoard board{{loadDeviceDescription("vishard10")}, nullptr};
  BoardServer server{board, "127.0.0.1", 0};

  void say(const Socket& socket, const Bytes& bytes) {
    ASSERT_EQ(::send(socket.get(), bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }
  /// Turns the server until so much has come, or the server has hung up, or turned for long in vain.
  Bytes hear(const Socket& socket, std::size_t count) {
    Bytes heard;
    for (int turn = 0; turn < 20'000 && heard.size() < count; ++turn) {
      server.turn();
      Bytes piece(count - heard.size());
      const ssize_t got = ::recv(socket.get(), piece.data(), piece.size(), MSG_DONTWAIT);
      if (got == 0) break;
      if (got > 0) heard.insert(heard.end(), piece.begin(), piece.begin() + got);
    }
    return heard;
  }
};

TEST_F(Served, IsImportedConfiguredAndRead) {
  const Socket host = connectedTo(server.port());
  say(host, UsbIpWords::import("1-1"));
  EXPECT_EQ(UsbIpWords::word(hear(host, 320), 4), 0u);
  EXPECT_TRUE(server.isImported());
  say(host, UsbIpWords::configure(1));
  EXPECT_EQ(UsbIpWords::word(hear(host, 48), 20), 0u);
  usb::StateFrame state;
  for (std::uint32_t i = 0; i < 50; ++i) {
    say(host, UsbIpWords::urb(10 + i, true, 1, 128));
    const Bytes answer = hear(host, 48 + usb::kStateSize);
    ASSERT_EQ(UsbIpWords::word(answer, 4), 10 + i);
    ASSERT_EQ(usb::decodeState(std::span(answer).subspan(48), usb::FrameForm::full, state), usb::FrameFault::none);
    ASSERT_EQ(state.sequence, i + 1);
  }
}

TEST_F(Served, MovesTheArmOfAHostThatCommandsIt) {
  const Socket host = connectedTo(server.port());
  say(host, UsbIpWords::import("1-1"));
  hear(host, 320);
  say(host, UsbIpWords::configure(1));
  hear(host, 48);
  const double before = board.angles()[0];
  BoardCommand command;
  command.drive.enabled = true;
  command.drive.jointRates[0] = 1;
  for (std::uint32_t i = 1; i <= 300; ++i) {
    command.sequence = command.heartbeat = i;
    const Bytes frame = usb::bytesOf(command, usb::FrameForm::full);
    say(host, UsbIpWords::urb(i, false, 1, static_cast<std::uint32_t>(frame.size()), {}, frame));
    ASSERT_EQ(hear(host, 48).size(), 48u);
    board.press(i > 2 ? kInputDeadMan : 0);
  }
  EXPECT_GT(board.angles()[0], before) << "however long it took";
}

TEST_F(Served, ListsItselfAndHangsUp) {
  const Socket host = connectedTo(server.port());
  say(host, UsbIpWords::list());
  EXPECT_EQ(hear(host, 1000).size(), 12u + 312 + 4);
}

TEST_F(Served, IsFreeWhenTheHostHasHungUp) {
  {
    const Socket host = connectedTo(server.port());
    say(host, UsbIpWords::import("1-1"));
    hear(host, 320);
    EXPECT_TRUE(server.isImported());
  }
  for (int turn = 0; turn < 1000 && server.isImported(); ++turn) server.turn();
  EXPECT_FALSE(server.isImported());
}

TEST_F(Served, HangsUpOnNonsenseAndSaysWhy) {
  const Socket host = connectedTo(server.port());
  say(host, Bytes(100, 'x'));
  EXPECT_TRUE(hear(host, 1).empty());
  EXPECT_THAT(server.newReproach(), HasSubstr("speaks no USB/IP"));
  EXPECT_EQ(server.newReproach(), "");
}

TEST_F(Served, TurnsAwayMoreThanItCanServeAndGoesOn) {
  std::vector<Socket> crowd;
  for (std::size_t i = 0; i < 2 * BoardServer::kMostPeers; ++i) {
    crowd.push_back(connectedTo(server.port()));
    server.turn();
  }
  crowd.clear();
  for (int turn = 0; turn < 50; ++turn) server.turn();
  const Socket host = connectedTo(server.port());
  say(host, UsbIpWords::list());
  EXPECT_EQ(hear(host, 328).size(), 328u);
}

TEST_F(Served, SaysWhoHasThePort) {
  try {
    const BoardServer second(board, "127.0.0.1", server.port());
    FAIL() << "two servers at one port";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("--port"));
  }
  EXPECT_THROW(BoardServer(board, "localhost", 0), std::runtime_error);
}

}  // namespace
}  // namespace haptiv
