#pragma once

#include <span>
#include <string_view>

namespace haptiv {

/// A device description that is part of the program.
struct BuiltInDescription {
  std::string_view name;  ///< without ".toml"
  std::string_view text;
};

/// The files of device/descriptions, as they were at build time.
std::span<const BuiltInDescription> builtInDescriptions() noexcept;

}  // namespace haptiv
