#pragma once

#include <atomic>
#include <cstdint>

namespace haptiv::usb {

/// What became of the packets of a link, since it was opened first.
struct LinkFigures {
  std::uint64_t states = 0;      ///< whole, and newer than the one before
  std::uint64_t damaged = 0;     ///< of a wrong length, magic, version, content or CRC: dropped
  std::uint64_t outOfOrder = 0;  ///< late or repeated: dropped
  std::uint64_t missing = 0;     ///< numbers that were never seen
  std::uint64_t stalls = 0;
  std::uint64_t tooLong = 0;
  std::uint64_t errors = 0;   ///< that the bus itself found
  std::uint64_t sent = 0;     ///< commands handed to the bus
  std::uint64_t skipped = 0;  ///< commands for which both transfers were busy
  std::uint64_t losses = 0;   ///< times that the device left
};

/// The same while it is being counted. Thread: one counts, any reads.
struct LinkCounters {
  std::atomic<std::uint64_t> states = 0, damaged = 0, outOfOrder = 0, missing = 0, stalls = 0, tooLong = 0, errors = 0,
                             sent = 0, skipped = 0, losses = 0;

  LinkFigures figures() const noexcept {
    return {states, damaged, outOfOrder, missing, stalls, tooLong, errors, sent, skipped, losses};
  }
};

}  // namespace haptiv::usb
