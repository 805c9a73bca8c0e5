#include "device/parsing/TomlValues.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace haptiv {
namespace {

constexpr double kLargest = 1e9;
constexpr std::size_t kLongestName = 60;

}  // namespace

std::string shown(std::string_view name) {
  std::string result;
  for (const char c : name.substr(0, kLongestName)) result += (c >= 0 && c < ' ') || c == 127 ? '?' : c;
  return name.size() > kLongestName ? result + "..." : result;
}

void TomlValues::fail(const toml::source_position& where, const std::string& message) const {
  std::ostringstream all;
  all << sourceName_ << ':' << where.line << ':' << where.column << ": " << message;
  throw std::runtime_error(all.str());
}

std::string TomlValues::text(const toml::node& node, const std::string& what) const {
  const auto value = node.value_exact<std::string>();
  if (!value || value->empty() || shown(*value) != *value)
    fail(node, what + " is no text of 1 to " + std::to_string(kLongestName) + " characters; write a name in quotes");
  return *value;
}

bool TomlValues::truth(const toml::node& node, const std::string& what) const {
  const auto value = node.value_exact<bool>();
  if (!value) fail(node, what + " is neither true nor false; write one of them");
  return *value;
}

double TomlValues::number(const toml::node& node, const std::string& what, Rule rule) const {
  if (!node.is_number()) fail(node, what + " is no number; write one, such as 0.5");
  const double value = node.value<double>().value_or(NAN);  // none: an integer that no double holds exactly
  if (!std::isfinite(value)) fail(node, what + " is not finite; write a finite number");
  if (std::abs(value) > kLargest) fail(node, what + " is beyond 1e9; write a smaller number, in SI units");
  if (rule == Rule::positive && value <= 0) fail(node, what + " must be greater than zero");
  if (rule == Rule::notNegative && value < 0) fail(node, what + " must not be negative");
  return value;
}

void TomlValues::numbers(const toml::node& node, const std::string& what, Rule rule, const std::string& entry,
                         std::span<double> values) const {
  const toml::array& entries = list(node, what, "one number a " + entry);
  if (entries.size() != values.size()) {
    fail(node, what + " has " + std::to_string(entries.size()) + " entries; give " + std::to_string(values.size()) +
                   ", one a " + entry);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = number(entries[i], what + " of " + entry + " " + std::to_string(i + 1), rule);
}

std::size_t TomlValues::choice(const toml::node& node, const std::string& what,
                               const std::vector<std::string>& names) const {
  const auto value = node.value_exact<std::string>();
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (value && *value == names[i]) return i;
    all += (all.empty() ? "'" : ", '") + names[i] + "'";
  }
  fail(node, what + " is none of " + all + "; write one of them");
}

const toml::table& TomlValues::table(const toml::node& node, const std::string& what) const {
  if (!node.is_table()) fail(node, what + " is no section; write [" + what + "] and its keys below");
  return *node.as_table();
}

const toml::array& TomlValues::list(const toml::node& node, const std::string& what, const std::string& of) const {
  if (!node.is_array()) fail(node, what + " is no list; write [a, b, ...], " + of);
  return *node.as_array();
}

}  // namespace haptiv
