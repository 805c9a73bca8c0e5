#include "app/session/csv/CsvLine.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace haptiv {
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

void CsvPlace::fail(const std::string& what) const {
  throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": " + what);
}

std::vector<std::string_view> cellsOf(std::string_view line, std::size_t most) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos || cells.size() > most) return cells;
    line.remove_prefix(comma + 1);
  }
}

double numberIn(std::string_view cell, const std::string& name, const CsvPlace& place) {
  if (cell.empty()) place.fail(name + " is empty. Fill the cell in, or delete the line");
  double number = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number))
    place.fail(name + " is \"" + std::string(cell.substr(0, 40)) +
               "\", which is no finite number. Write it with a decimal point, such as 0.25");
  return number;
}

}  // namespace haptiv
