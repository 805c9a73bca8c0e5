#include "app/calibration/LoadsFile.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "app/session/csv/CsvLine.h"

namespace haptiv {
namespace {

constexpr std::size_t kMostLoads = 1000, kLongestLine = 1000;
constexpr std::array kColumns = {"fx", "fy", "fz", "tx", "ty", "tz", "c1", "c2", "c3", "c4", "c5", "c6"};

/// How many columns the file has: 6, or 12.
std::size_t columnsIn(const std::string& header, const CsvPlace& place) {
  const auto cells = cellsOf(header, kColumns.size());
  if ((cells.size() != 6 && cells.size() != 12) || !std::equal(cells.begin(), cells.end(), kColumns.begin()))
    place.fail(
        "the columns are \"" + header.substr(0, 80) +
        "\". Make the first line fx,fy,fz,tx,ty,tz (N, N m); c1,c2,c3,c4,c5,c6, the sensor's counts, may follow");
  return cells.size();
}

KnownLoad loadIn(const std::string& line, std::size_t columns, const CsvPlace& place) {
  const auto cells = cellsOf(line, columns);
  if (cells.size() != columns)
    place.fail("the line has " + std::to_string(cells.size()) + " cells. Give all " + std::to_string(columns) +
               " of the header in every line");
  Vector6 load, counts;
  for (std::size_t i = 0; i < columns; ++i)
    (i < 6 ? load : counts)[static_cast<int>(i % 6)] = numberIn(cells[i], kColumns[i], place);
  return {load, columns == 12 ? std::optional(counts) : std::nullopt};
}

}  // namespace

std::vector<KnownLoad> readLoadsFile(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read: check the path and its permissions");
  CsvPlace place{path, 0};
  std::vector<KnownLoad> loads;
  std::size_t columns = 0;
  for (std::string line; std::getline(file, line);) {
    ++place.line;
    if (line.size() > kLongestLine) place.fail("the line is longer than 1000 characters; this is no file of loads");
    if (trimmed(line).empty()) continue;
    if (columns == 0) {
      columns = columnsIn(line, place);
      continue;
    }
    if (loads.size() == kMostLoads) place.fail("more than 1000 loads; a dozen will do");
    loads.push_back(loadIn(line, columns, place));
  }
  if (loads.empty())
    throw std::runtime_error(path.string() + ": no load in it; give the header fx,fy,fz,tx,ty,tz and a line a load");
  return loads;
}

std::string loadsText(const std::vector<Vector6>& loads) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "fx,fy,fz,tx,ty,tz\n";
  for (const Vector6& load : loads)
    for (int axis = 0; axis < 6; ++axis) text << load[axis] << (axis < 5 ? "," : "\n");
  return text.str();
}

}  // namespace haptiv
