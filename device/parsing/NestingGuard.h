#pragma once

#include <optional>
#include <string_view>

namespace haptiv {

/// The line of the first key with more parts than any description has, a.a.a...: the TOML library recurses into them
/// without a bound, and would take the stack down. What the library bounds itself is left to it.
std::optional<unsigned> lineOfEndlessKey(std::string_view toml);

}  // namespace haptiv
