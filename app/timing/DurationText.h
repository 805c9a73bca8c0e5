#pragma once

#include <string>

namespace haptiv {

/// "850 ns", "12.3 us", "1.25 ms", "2.1 s".
std::string durationText(double nanoseconds);

}  // namespace haptiv
