#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device/types.h"

namespace haptiv {

/// What a number may be. Whatever the rule, one that is not finite or beyond 1e9 is refused.
enum class Rule { any, notNegative, positive };

/// Values out of a TOML document that may hold anything. `what` names a value in messages: "links.lift".
/// Everything throws std::runtime_error "NAME:LINE:COLUMN: what, and what to do" where the document holds no such
/// value.
class TomlValues {
 public:
  explicit TomlValues(std::string sourceName) : sourceName_(std::move(sourceName)) {}

  [[noreturn]] void fail(const toml::source_position& where, const std::string& message) const;
  [[noreturn]] void fail(const toml::node& node, const std::string& message) const {
    fail(node.source().begin, message);
  }

  std::string text(const toml::node& node, const std::string& what) const;
  bool truth(const toml::node& node, const std::string& what) const;
  double number(const toml::node& node, const std::string& what, Rule rule) const;
  /// As many numbers as `values` has room for. `entry` names one of them: "joint" gives "of joint 3".
  void numbers(const toml::node& node, const std::string& what, Rule rule, const std::string& entry,
               std::span<double> values) const;
  /// Which of the names it is.
  std::size_t choice(const toml::node& node, const std::string& what, const std::vector<std::string>& names) const;
  const toml::table& table(const toml::node& node, const std::string& what) const;
  const toml::array& list(const toml::node& node, const std::string& what, const std::string& of) const;

 private:
  std::string sourceName_;
};

/// A name of the document's for a message: short, and with nothing in it that a terminal would obey.
std::string shown(std::string_view name);

}  // namespace haptiv
