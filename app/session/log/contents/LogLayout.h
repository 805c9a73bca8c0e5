#pragma once

#include <cstdint>

/// Names and numbers that writer and reader of a session log share; the columns of /servo are in TickColumns.h.
///
///   /                  attributes: format, format_version, software_version, git_hash, seed, rate_hz, start_utc,
///                      scheduling, fault (of a flight record; empty: none)
///   /meta/device_toml  the device description, UTF-8, a byte a row; likewise scene_name and scene_iv
///   /meta/end          complete and dropped (one row once the session has ended), reason (text; why it ended early)
///   /scenes/index      a row a scene: version, offset and length in /scenes/text, offset and length in /scenes/bytes
///   /scenes/text       .iv texts of all scenes, one after the other
///   /scenes/bytes      the same scenes compiled (haptics/bytes/SceneBytes.h)
///   /events            a row an event: tick, time, kind (index into the attribute kinds), code (a state: index into
///                      states; a fault or a trip: index into faults, trips). None in format 1
///   /servo/GROUP       a row a tick; attributes: columns, unit (of each column), frame. No device_time_us before
///                      format 3
namespace haptiv::log_layout {

inline constexpr const char* kFormat = "haptiv-session";
inline constexpr std::uint64_t kFormatVersion = 3;

inline constexpr const char* kDeviceText = "/meta/device_toml";
inline constexpr const char* kSceneName = "/meta/scene_name";
inline constexpr const char* kSceneText = "/meta/scene_iv";
inline constexpr const char* kComplete = "/meta/end/complete";
inline constexpr const char* kDropped = "/meta/end/dropped";
inline constexpr const char* kReason = "/meta/end/reason";
inline constexpr const char* kSceneIndex = "/scenes/index";
inline constexpr const char* kSceneTexts = "/scenes/text";
inline constexpr const char* kSceneBytes = "/scenes/bytes";
inline constexpr const char* kEvents = "/events";
inline constexpr const char* kServo = "/servo/";

inline constexpr std::size_t kIndexColumns = 5;
inline constexpr std::size_t kEventColumns = 4;
inline constexpr double kFlushInterval = 0.5;  ///< of session time [s]; a chunk holds that many ticks

}  // namespace haptiv::log_layout
