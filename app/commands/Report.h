#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "device/types.h"
#include "scenegraph/Diagnostic.h"

namespace haptiv {

/// What a command found out: names with values, in order. Printed as one JSON object for programs, or as a table for
/// people, in which `max_force_N 3` reads `max force  3 N`.
class Report {
 public:
  using Numbers = std::vector<double>;
  using Rows = std::vector<Numbers>;
  using Names = std::vector<std::string>;
  using List = std::vector<Report>;  ///< the table gives only its length
  using Value = std::variant<std::nullptr_t, bool, std::uint64_t, double, std::string, Numbers, Rows, Names, List>;

  /// Names are lower case with underscores and, where there is one, the SI unit at the end: `_N`, `_m`, `_s`, `_ns`,
  /// `_Hz`.
  void add(std::string name, Value value) { items_.emplace_back(std::move(name), std::move(value)); }
  /// A part of its own with names and values; null in its place is added as a value.
  void addPart(std::string name, const Report& part) { items_.emplace_back(std::move(name), Part{{part}}); }

  std::string toJson() const;
  std::string toText() const;
  /// To stdout. Throws CommandFailure where that cannot be written.
  void print(bool json) const;

 private:
  struct Part {
    List one;  // exactly one; a list because Report is not complete here
  };
  using Item = std::pair<std::string, std::variant<Value, Part>>;
  friend struct ReportWriter;
  std::vector<Item> items_;
};

/// {line, node, message} of every diagnostic of this severity.
Report::List listOf(const Diagnostics& diagnostics, Diagnostic::Severity severity);
Report::Numbers numbers(const Vector3& v);

}  // namespace haptiv
