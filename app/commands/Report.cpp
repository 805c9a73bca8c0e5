#include "app/commands/Report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/commands/ExitCode.h"

namespace haptiv {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 6;      // in tables
constexpr int kAllDigits = 17;  // where two doubles are compared
constexpr int kRowCell = 12;    // characters a number of a matrix

std::string text(double number, int digits) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, number == 0 ? 0.0 : number);
  return buffer.data();
}

/// "max_force_N" -> "max force" and " N".
std::pair<std::string, std::string> labelAndUnit(std::string name) {
  std::string unit;
  for (const std::string_view suffix : {"N", "m", "s", "ns", "Hz"}) {
    if (name.ends_with("_" + std::string(suffix))) {
      unit = " " + std::string(suffix);
      name.resize(name.size() - suffix.size() - 1);
      break;
    }
  }
  std::ranges::replace(name, '_', ' ');
  return {name, unit};
}

}  // namespace

/// Both ways of writing a report, item by item.
struct ReportWriter {
  static Json json(const Report& report) {
    Json object = Json::object();
    for (const auto& [name, item] : report.items_) {
      if (const auto* part = std::get_if<Report::Part>(&item)) {
        object[name] = json(part->one.front());
      } else {
        std::visit([&object, &name = name](const auto& value) { object[name] = json(value); },
                   std::get<Report::Value>(item));
      }
    }
    return object;
  }
  static Json json(const Report::List& list) {
    Json array = Json::array();
    for (const Report& each : list) array.push_back(json(each));
    return array;
  }
  template <typename T>
  static Json json(const T& plain) {
    return plain;
  }

  struct Text {
    int digits = kDigits;
    std::string unit;

    std::string operator()(std::nullptr_t) const { return "none"; }
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
    std::string operator()(std::uint64_t value) const { return std::to_string(value) + unit; }
    std::string operator()(double value) const { return text(value, digits) + unit; }
    std::string operator()(const std::string& value) const { return value.empty() ? "none" : value; }
    std::string operator()(const Report::List& value) const { return std::to_string(value.size()); }
    std::string operator()(const Report::Numbers& value) const {
      std::string line;
      for (const double number : value) line += (line.empty() ? "" : "  ") + text(number, digits);
      return line + unit;
    }
    std::string operator()(const Report::Names& value) const {
      std::string line;
      for (const std::string& name : value) line += (line.empty() ? "" : ", ") + name;
      return line.empty() ? "none" : line;
    }
    std::string operator()(const Report::Rows& value) const {
      std::string lines;
      for (const Report::Numbers& row : value) {
        lines += "\n   ";
        for (const double number : row) {
          const std::string cell = text(number, digits);
          lines += std::string(kRowCell - std::min<std::size_t>(kRowCell - 1, cell.size()), ' ') + cell;
        }
      }
      return lines + unit;
    }
    std::string operator()(const Report::Value& value) const { return std::visit(*this, value); }
    std::string operator()(const Report::Part& part) const {
      std::string line;
      for (const auto& [name, item] : part.one.front().items_) {
        const auto [label, itsUnit] = labelAndUnit(name);
        line += (line.empty() ? "" : ", ") + label + " " + std::visit(Text{kAllDigits, itsUnit}, item);
      }
      return line;
    }
  };
};

std::string Report::toJson() const {
  return ReportWriter::json(*this).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string Report::toText() const {
  std::size_t width = 0;
  for (const auto& [name, item] : items_) width = std::max(width, labelAndUnit(name).first.size());
  std::string table;
  for (const auto& [name, item] : items_) {
    const auto [label, unit] = labelAndUnit(name);
    const std::string value = std::visit(ReportWriter::Text{kDigits, unit}, item);
    const bool below = value.starts_with('\n');  // rows of a matrix
    table += "  " + label + (below ? "" : std::string(width - label.size() + 3, ' ')) + value + "\n";
  }
  return table;
}

void Report::print(bool json) const {
  std::cout << (json ? toJson() : toText()) << std::flush;
  if (!std::cout)
    throw CommandFailure(kCouldNot, "standard output cannot be written; the disk may be full or the pipe closed");
}

Report::List listOf(const Diagnostics& diagnostics, Diagnostic::Severity severity) {
  Report::List list;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != severity) continue;
    Report& entry = list.emplace_back();
    entry.add("file", diagnostic.file);
    entry.add("line", static_cast<std::uint64_t>(std::max(0, diagnostic.line)));
    entry.add("node", diagnostic.node);
    entry.add("message", diagnostic.message);
  }
  return list;
}

Report::Numbers numbers(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace haptiv
