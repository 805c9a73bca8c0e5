#pragma once

#include <optional>
#include <string_view>

namespace haptiv {

/// That of the options whose nameOf is this one; nothing where there is none.
template <typename Options>
auto optionNamed(const Options& options, std::string_view name) -> std::optional<typename Options::value_type> {
  for (const auto option : options)
    if (nameOf(option) == name) return option;
  return std::nullopt;
}

}  // namespace haptiv
