#include "app/session/hands/HandFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/session/csv/CsvLine.h"

namespace haptiv {
namespace {

constexpr std::size_t kLargestFile = 64u << 20;  // [bytes]
constexpr std::size_t kMostWaypoints = 1'000'000;
constexpr std::size_t kColumns = 4;
constexpr std::array<const char*, kColumns> kNames{"t", "x", "y", "z"};

/// A column that may stand after these: 1 while the button is pressed, 0 else.
struct Button {
  const char* name;
  std::uint16_t input;
};
constexpr std::array kButtons = {Button{"deadman", kInputDeadMan}, Button{"estop", kInputEmergencyStop1},
                                 Button{"reset", kInputReset}};
constexpr std::size_t kMostColumns = kColumns + kButtons.size();
constexpr std::size_t kSampledFrom = 8;  // steps that a file has at least to be called sampled
constexpr double kHole = 10;             // a step longer than so many usual ones is a hole

/// The buttons whose columns the file has, in its order.
std::vector<Button> buttonsIn(std::string_view header, const CsvPlace& place) {
  const std::vector<std::string_view> cells = cellsOf(header, kMostColumns);
  const auto fail = [&] {
    place.fail(
        "the columns are \"" + std::string(header.substr(0, 80)) +
        "\". Make the first line t,x,y,z (seconds, metres), separated by commas; deadman, estop, reset may follow");
  };
  if (cells.size() < kColumns || !std::equal(kNames.begin(), kNames.end(), cells.begin())) fail();
  std::vector<Button> buttons;
  for (std::size_t i = kColumns; i < cells.size(); ++i) {
    const auto named = [&](const Button& button) { return cells[i] == button.name; };
    const auto button = std::find_if(kButtons.begin(), kButtons.end(), named);
    if (button == kButtons.end() || std::any_of(buttons.begin(), buttons.end(), named)) fail();
    buttons.push_back(*button);
  }
  return buttons;
}

HandWaypoint waypointIn(std::string_view line, const std::vector<Button>& buttons, const CsvPlace& place) {
  const std::vector<std::string_view> cells = cellsOf(line, kMostColumns);
  const std::size_t columns = kColumns + buttons.size();
  if (cells.size() != columns)
    place.fail(
        (cells.size() > columns ? "more than " + std::to_string(columns) : "only " + std::to_string(cells.size())) +
        " cells. Give " + (buttons.empty() ? "t,x,y,z" : "all the columns of the header") +
        " in every line, separated by commas");
  std::array<double, kColumns> numbers{};
  for (std::size_t i = 0; i < kColumns; ++i) numbers[i] = numberIn(cells[i], kNames[i], place);
  HandWaypoint waypoint{numbers[0], Vector3(numbers[1], numbers[2], numbers[3])};
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    const std::string_view cell = cells[kColumns + i];
    if (cell != "0" && cell != "1")
      place.fail(std::string(buttons[i].name) + " is \"" + std::string(cell.substr(0, 40)) +
                 "\". Write 1 while it is pressed and 0 else");
    const unsigned others = waypoint.inputs & ~unsigned{buttons[i].input};
    waypoint.inputs = static_cast<std::uint16_t>(cell == "1" ? others | buttons[i].input : others);
  }
  return waypoint;
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
void expectNoHole(const std::vector<HandWaypoint>& waypoints, const std::vector<std::size_t>& lines, CsvPlace place) {
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
  CsvPlace place{path};
  std::optional<std::vector<Button>> buttons;
  std::vector<HandWaypoint> waypoints;
  std::vector<std::size_t> lines;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++place.line;
    if (line.empty() || line.front() == '#') continue;
    if (!buttons) {
      buttons = buttonsIn(line, place);
      continue;
    }
    const HandWaypoint waypoint = waypointIn(line, *buttons, place);
    if (!waypoints.empty() && waypoint.time <= waypoints.back().time)
      place.fail("t is " + shortNumber(waypoint.time) + " s, after " + shortNumber(waypoints.back().time) +
                 " s in the line before. Make the times rise");
    if (waypoints.size() == kMostWaypoints) place.fail("more than a million lines. Give fewer");
    waypoints.push_back(waypoint);
    lines.push_back(place.line);
  }
  place.line = std::max<std::size_t>(place.line, 1);
  if (!buttons) place.fail("the file is empty. Make the first line t,x,y,z and give the hand's places below it");
  if (waypoints.empty()) place.fail("no waypoint below the header. Give at least one line t,x,y,z");
  expectNoHole(waypoints, lines, place);
  return waypoints;
}

}  // namespace haptiv
