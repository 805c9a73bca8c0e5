#pragma once

#include <cstdint>
#include <string>

namespace haptiv {

/// What stands at the head of a session log.
struct SessionHeader {
  std::string sceneName;   ///< path of the scene as the user named it
  std::string sceneText;   ///< the .iv text at the start
  std::string deviceText;  ///< the device description, TOML
  std::string softwareVersion;
  std::string gitHash;
  std::string startUtc;    ///< ISO 8601; empty in --fast runs, which have no clock
  std::string scheduling;  ///< how the servo thread ran
  std::uint64_t seed = 0;
  double rate = 1000;  ///< [Hz]
  std::string fault;   ///< of a flight record: what the session went into; empty: the log is of a whole session
};

}  // namespace haptiv
