#pragma once

#include <string>
#include <string_view>

namespace haptiv {

/// Why a node is not read at all: it opens other files, or crashes Coin. Empty where it is read.
std::string refusedNode(std::string_view keyword);

/// Why the text's first line is no header that can be read; empty where it is one.
std::string headerFault(std::string_view text);

}  // namespace haptiv
