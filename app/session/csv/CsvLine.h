#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace haptiv {

/// A place in a CSV file, for what is said of it.
struct CsvPlace {
  const std::filesystem::path& path;
  std::size_t line = 0;

  /// Throws std::runtime_error "FILE:LINE: what".
  [[noreturn]] void fail(const std::string& what) const;
};

/// Without blanks before and after.
std::string_view trimmed(std::string_view text);

/// The cells of a line without the blanks around them; of more than `most`, one more than that.
std::vector<std::string_view> cellsOf(std::string_view line, std::size_t most);

/// The finite number in a cell. `name` is its column's, for messages.
double numberIn(std::string_view cell, const std::string& name, const CsvPlace& place);

}  // namespace haptiv
