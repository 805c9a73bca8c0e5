#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace haptiv {

/// A key of a description and what is to be written for it, as TOML: "[1, 2, 3]".
struct KeyValue {
  std::string_view section, key;
  std::string value;
};

/// The same text with these keys set, and every other byte as it was: comments, order, blanks, line ends. A key that is
/// there keeps its place; a new one comes to stand below its section's head, a new section at the end.
/// Throws std::runtime_error where the text is no TOML, or tells the section in a way that cannot be added to
/// ("sensor = {...}", "sensor.bias = ..." outside of a section); `sourceName` stands before the message.
std::string withKeys(std::string_view toml, const std::vector<KeyValue>& values, const std::string& sourceName);

}  // namespace haptiv
