#include "app/session/HandFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace haptiv {
namespace {

constexpr std::size_t kLargestFile = 64u << 20;  // [bytes]
constexpr std::size_t kMostWaypoints = 1'000'000;
constexpr std::size_t kColumns = 4;
constexpr std::array<const char*, kColumns> kNames{"t", "x", "y", "z"};
constexpr std::size_t kSampledFrom = 8;  // steps that a file has at least to be called sampled
constexpr double kHole = 10;             // a step longer than so many usual ones is a hole

/// A place in the file, for what is said of it.
struct Place {
  const std::filesystem::path& path;
  std::size_t line = 0;

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": " + what);
  }
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos || cells.size() > kColumns) return cells;
    line.remove_prefix(comma + 1);
  }
}

void expectHeader(std::string_view line, const Place& place) {
  const std::vector<std::string_view> cells = cellsOf(line);
  if (!std::equal(cells.begin(), cells.end(), kNames.begin(), kNames.end()))
    place.fail("the columns are \"" + std::string(line.substr(0, 80)) +
               "\". Make the first line t,x,y,z (seconds, metres), separated by commas");
}

double numberIn(std::string_view cell, const char* name, const Place& place) {
  if (cell.empty()) place.fail(std::string(name) + " is empty. Fill the cell in, or delete the line");
  double number = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number))
    place.fail(std::string(name) + " is \"" + std::string(cell.substr(0, 40)) +
               "\", which is no finite number. Write it with a decimal point, such as 0.25");
  return number;
}

HandWaypoint waypointIn(std::string_view line, const Place& place) {
  const std::vector<std::string_view> cells = cellsOf(line);
  if (cells.size() != kColumns)
    place.fail((cells.size() > kColumns ? "more than 4" : "only " + std::to_string(cells.size())) +
               " cells. Give t,x,y,z in every line, separated by commas");
  std::array<double, kColumns> numbers{};
  for (std::size_t i = 0; i < kColumns; ++i) numbers[i] = numberIn(cells[i], kNames[i], place);
  return {numbers[0], Vector3(numbers[1], numbers[2], numbers[3])};
}

std::string contentOf(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw std::runtime_error(path.string() + ": there is no such hand file. Give the path of a CSV file with t,x,y,z");
  if (std::filesystem::file_size(path, error) > kLargestFile)
    throw std::runtime_error(path.string() + ": larger than 64 MiB. Give a hand file with fewer lines");
  std::ifstream stream(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw std::runtime_error(path.string() + ": cannot be read. Ask its owner for permission");
  return content;
}

std::string shortNumber(double number) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

/// A recording has nearly the same step everywhere; a few waypoints by hand have not, and may be as far apart as they
/// like.
void expectNoHole(const std::vector<HandWaypoint>& waypoints, const std::vector<std::size_t>& lines, Place place) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < waypoints.size(); ++i) steps.push_back(waypoints[i].time - waypoints[i - 1].time);
  if (steps.size() < kSampledFrom) return;
  std::vector<double> sorted = steps;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  const auto near =
      std::count_if(steps.begin(), steps.end(), [usual](double step) { return step > usual / 2 && step < usual * 2; });
  if (static_cast<double>(near) < 0.75 * static_cast<double>(steps.size())) return;
  const auto hole = std::find_if(steps.begin(), steps.end(), [usual](double step) { return step > kHole * usual; });
  if (hole == steps.end()) return;
  const auto after = static_cast<std::size_t>(hole - steps.begin()) + 1;
  place.line = lines[after];
  place.fail("a hole from " + shortNumber(waypoints[after - 1].time) + " s to " + shortNumber(waypoints[after].time) +
             " s in a file sampled every " + shortNumber(usual) + " s. Fill in the missing lines");
}

}  // namespace

std::vector<HandWaypoint> readHandFile(const std::filesystem::path& path) {
  const std::string content = contentOf(path);
  std::string_view rest = content;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // byte order mark, as spreadsheets write it
  Place place{path};
  bool headerSeen = false;
  std::vector<HandWaypoint> waypoints;
  std::vector<std::size_t> lines;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++place.line;
    if (line.empty() || line.front() == '#') continue;
    if (!headerSeen) {
      expectHeader(line, place);
      headerSeen = true;
      continue;
    }
    const HandWaypoint waypoint = waypointIn(line, place);
    if (!waypoints.empty() && waypoint.time <= waypoints.back().time)
      place.fail("t is " + shortNumber(waypoint.time) + " s, after " + shortNumber(waypoints.back().time) +
                 " s in the line before. Make the times rise");
    if (waypoints.size() == kMostWaypoints) place.fail("more than a million lines. Give fewer");
    waypoints.push_back(waypoint);
    lines.push_back(place.line);
  }
  place.line = std::max<std::size_t>(place.line, 1);
  if (!headerSeen) place.fail("the file is empty. Make the first line t,x,y,z and give the hand's places below it");
  if (waypoints.empty()) place.fail("no waypoint below the header. Give at least one line t,x,y,z");
  expectNoHole(waypoints, lines, place);
  return waypoints;
}

}  // namespace haptiv
