#pragma once

#include <string>
#include <string_view>

namespace haptiv {

/// Why a file's first line is no header that Coin can read; empty where it is one.
std::string headerFault(std::string_view text);

bool isBinaryHeader(std::string_view text);

}  // namespace haptiv
