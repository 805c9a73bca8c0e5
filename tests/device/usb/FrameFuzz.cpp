// Throws wrong frames at both ends of the wire until its time is over: HAPTIV_FUZZ_SECONDS, else a minute.
//
//     frame_fuzz [SEED]
//
// The laws: nothing crashes, no frame with a wrong CRC is accepted, and whatever is accepted, the board's set-points
// are finite and within the drives' limits.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <random>

#include "device/usb/peripheral/BoardPort.h"
#include "tests/device/usb/FrameSamples.h"

namespace haptiv::usb {
namespace {

/// Breaks packets, and now and then mends the checksum of what it broke.
class Breaker {
 public:
  explicit Breaker(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t count) { return random_() % count; }

  void damage(Packet& bytes) {
    for (std::size_t times = below(6); times > 0; --times) {
      const std::size_t at = bytes.empty() ? 0 : below(bytes.size());
      switch (below(6)) {
        case 0:
          if (!bytes.empty()) bytes[at] ^= static_cast<std::uint8_t>(1u << below(8));
          break;
        case 1:
          if (!bytes.empty()) bytes[at] = static_cast<std::uint8_t>(random_());
          break;
        case 2:
          bytes.resize(below(140));
          break;
        case 3:
          bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), static_cast<std::uint8_t>(random_()));
          break;
        case 4:
          if (!bytes.empty()) bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
          break;
        default:
          for (auto& byte : bytes)
            if (below(4) == 0) byte = below(2) ? 0xff : 0x80;
      }
    }
    if (bytes.size() >= 4 && below(2) == 0) mend(bytes);
  }

 private:
  static void mend(Packet& bytes) {
    const std::uint32_t crc = crc32(std::span(bytes).first(bytes.size() - 4));
    for (int i = 0; i < 4; ++i) bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
  }
  std::mt19937_64 random_;
};

bool crcIsRight(const Packet& bytes) {
  if (bytes.size() < 4) return false;
  std::uint32_t crc = 0;
  for (int i = 0; i < 4; ++i) crc |= static_cast<std::uint32_t>(bytes[bytes.size() - 4 + i]) << 8 * i;
  return crc == crc32(std::span(bytes).first(bytes.size() - 4));
}

[[noreturn]] void broken(const char* law, const Packet& bytes) {
  std::cerr << law << ", by";
  for (const unsigned byte : bytes) std::cerr << " " << byte;
  std::cerr << std::endl;
  std::abort();
}

struct Bench {
  explicit Bench(FrameForm wanted) : form(wanted) {}

  void hostReads(Breaker& breaker, FrameSamples& samples) {
    Packet bytes = bytesOf(samples.state(), form);
    breaker.damage(bytes);
    const bool taken = decodeState(bytes, form, known) == FrameFault::none;
    accepted += taken;
    if (taken && !crcIsRight(bytes)) broken("the host accepted a state with a wrong CRC", bytes);
  }

  void boardReads(Breaker& breaker, FrameSamples& samples) {
    const DriveMode wanted = breaker.below(2) ? DriveMode::rate : DriveMode::torque;
    BoardCommand command = samples.command();
    command.drive.mode = wanted;
    command.drive.enabled = true;
    command.sequence = board.report().lastSequence + 1;
    command.heartbeat = command.sequence;
    Packet bytes = bytesOf(command, form);
    breaker.damage(bytes);
    const std::uint32_t before = board.report().counters.accepted;
    port.packetOut(bytes);
    const bool taken = board.report().counters.accepted != before;
    accepted += taken;
    if (taken && !crcIsRight(bytes)) broken("the board accepted a command with a wrong CRC", bytes);
    BoardInputs inputs;  // an operator who resets and takes the handle again and again
    inputs.buttons = step % 4 == 1 ? kInputReset : step % 4 >= 2 ? kInputDeadMan : 0;
    board.advance(++step * 500, inputs);
    const DriveDemand demand = board.demand();
    drove += !demand.braked;
    const auto& settings = board.settings();
    const JointVector& limit = demand.mode == DriveMode::rate ? settings.rateLimit : settings.torqueLimit;
    if (!(demand.setPoints.cwiseAbs().array() <= limit.array()).all())
      broken("an unsafe set-point was accepted", bytes);
  }

  void controlReads(Breaker& breaker) {
    Packet bytes = breaker.below(2) ? bytesOf(board.thresholds()) : bytesOf(HomeCounts{});
    breaker.damage(bytes);
    const auto request = static_cast<std::uint8_t>(breaker.below(7));
    if (port.controlOut(request, bytes) && !crcIsRight(bytes)) broken("a control request with a wrong CRC", bytes);
    if (!noLooser(board.thresholds(), board.settings().thresholds)) broken("the safety circuit was loosened", bytes);
    Identity identity;
    Packet name = bytesOf(Identity{1, 10, "vishard10"});
    breaker.damage(name);
    if (decode(name, identity) == FrameFault::none && !crcIsRight(name)) broken("an identity with a wrong CRC", name);
  }

  FrameForm form;
  Board board{boardSettings(loadDeviceDescription("vishard10"))};
  BoardPort port{board, form, {1, 10, "vishard10"}};
  StateFrame known;
  std::int64_t step = 0;
  long accepted = 0, drove = 0;
};

void fuzz(std::uint64_t seed, std::chrono::seconds time) {
  Breaker breaker(seed);
  FrameSamples samples(seed);
  Bench full(FrameForm::full), packed(FrameForm::packed);
  const auto end = std::chrono::steady_clock::now() + time;
  long rounds = 0;
  while (rounds++ % 256 != 0 || std::chrono::steady_clock::now() < end) {
    for (Bench* bench : {&full, &packed}) {
      bench->hostReads(breaker, samples);
      bench->boardReads(breaker, samples);
      bench->controlReads(breaker);
    }
  }
  std::cout << rounds << " rounds, " << full.accepted + packed.accepted << " frames accepted, drives on "
            << full.drove + packed.drove << " times\n";
  if (full.drove == 0 || packed.drove == 0) broken("the drives were never on: the fuzzer tests nothing", {});
}

}  // namespace
}  // namespace haptiv::usb

int main(int argc, char** argv) {
  const char* asked = std::getenv("HAPTIV_FUZZ_SECONDS");
  const std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : std::random_device{}();
  std::cout << "seed " << seed << std::endl;
  haptiv::usb::fuzz(seed, std::chrono::seconds(asked ? std::atoi(asked) : 60));
}
