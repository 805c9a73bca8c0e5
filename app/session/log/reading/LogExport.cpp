#include "app/session/log/reading/LogExport.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "app/session/log/contents/TickColumns.h"

namespace haptiv {
namespace {

/// The columns, time first; nanoseconds become seconds.
std::vector<TickColumn> exportColumns() {
  std::vector<TickColumn> columns;
  for (TickGroup& group : tickGroups())
    for (TickColumn& column : group.columns) {
      if (column.unit == "ns") {
        column.name.replace(column.name.rfind("_ns"), 3, "_s");
        column.value = [nanoseconds = column.value](const TickRecord& tick) { return nanoseconds(tick) / 1e9; };
      }
      const bool isTime = column.name == "time_s";
      if (isTime) column.name = "t_s";
      columns.insert(isTime ? columns.begin() : columns.end(), std::move(column));
    }
  return columns;
}

void addNumber(std::string& line, double number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  line.append(digits.data(), end);
}

}  // namespace

void exportCsv(const SessionLog& log, const std::filesystem::path& path) {
  const std::vector<TickColumn> columns = exportColumns();
  std::ofstream stream(path, std::ios::binary);
  std::string lines;
  for (const TickColumn& column : columns) lines += (lines.empty() ? "" : ",") + column.name;
  lines += '\n';
  for (std::uint64_t first = 0; first < log.tickCount() && stream; first += SessionLog::kBlock) {
    for (const TickRecord& tick : log.ticks(first, SessionLog::kBlock)) {
      for (const TickColumn& column : columns) {
        addNumber(lines, column.value(tick));
        lines += ',';
      }
      lines.back() = '\n';
    }
    stream << lines;
    lines.clear();
  }
  stream << lines;
  stream.close();
  if (!stream)
    throw std::runtime_error(path.string() +
                             ": cannot write the table. Choose a folder that exists, and look for free space there");
}

}  // namespace haptiv
