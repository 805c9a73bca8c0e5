#pragma once

#include <array>
#include <chrono>
#include <ctime>
#include <string>

namespace haptiv {

/// Now, such as "2006-01-02T15:04:05Z".
inline std::string utcNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text.data(), length};
}

}  // namespace haptiv
