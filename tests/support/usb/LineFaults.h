#pragma once

namespace haptiv::test {

/// What befalls the next packets between a virtual device and the host: each counts down by one as it happens.
struct LineFaults {
  // To the packets that the device sends.
  int corrupt = 0;   ///< a bit is turned over that the bus's own check did not see
  int lose = 0;      ///< nothing comes of it
  int repeat = 0;    ///< comes twice
  int swap = 0;      ///< comes after the one behind it
  int shorten = 0;   ///< the last bytes are missing
  int lengthen = 0;  ///< bytes too many, that still fit the host's buffer
  int babble = 0;    ///< more bytes than the host has room for: the bus reports an overflow
  int damage = 0;    ///< the bus finds a wrong check sum after all its retries: EPROTO
  int stallIn = 0;   ///< the endpoint is halted
  int stallOut = 0;  ///< so is that of the commands
  // To the packets that the host sends.
  int corruptOut = 0;
  int loseOut = 0;
  int repeatOut = 0;
  int leaveAtControl = 0;  ///< the device is gone at the control request of this number from now, 1 the next
  // While set.
  bool holdOut = false;        ///< the device takes no packet: they stay on their way
  bool frozen = false;         ///< the device does nothing: no packet in or out, no time passes for it
  bool silentControl = false;  ///< control requests are never answered
};

/// Takes one of a counter.
inline bool befalls(int& count) {
  if (count <= 0) return false;
  --count;
  return true;
}

}  // namespace haptiv::test
