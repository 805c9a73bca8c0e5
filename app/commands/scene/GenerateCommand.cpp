#include "app/commands/scene/GenerateCommand.h"

#include <charconv>
#include <memory>
#include <string_view>

#include "app/commands/ExitCode.h"
#include "app/commands/Report.h"
#include "app/generate/MazeScene.h"
#include "app/generate/ReliefScene.h"
#include "scenegraph/writing/SceneSaver.h"

namespace haptiv {
namespace {

constexpr int kFewest = 2;
constexpr int kMost = 1000;
constexpr Range kSeeds{0, 2147483647};

struct GenerateOptions {
  std::string cells;
  int seed = 1;
  std::string out;
  std::string hand;
  bool json = false;
};

struct Cells {
  int columns = 0;
  int rows = 0;
};

/// "NxM". Throws CommandFailure (kWrongUsage) that says what is wanted.
Cells parseCells(const std::string& text) {
  Cells cells;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, cells.columns);
  const bool isCross = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = isCross ? std::from_chars(first.ptr + 1, end, cells.rows) : first;
  const auto fits = [](int count) { return count >= kFewest && count <= kMost; };
  if (!isCross || second.ec != std::errc() || second.ptr != end || !fits(cells.columns) || !fits(cells.rows))
    throw CommandFailure(kWrongUsage, "--cells " + text + ": write columns x rows, from " + std::to_string(kFewest) +
                                          " to " + std::to_string(kMost) + " each, such as 20x20");
  return cells;
}

void save(const std::string& text, const std::string& path) {
  try {
    saveText(text, path);
  } catch (const std::exception& error) {
    throw CommandFailure(kCouldNot, error.what());
  }
}

int generateMaze(const GenerateOptions& options) {
  const Cells cells = parseCells(options.cells);
  const auto seed = static_cast<std::uint64_t>(options.seed);
  const MazeScene scene(Maze(cells.columns, cells.rows, seed), seed);
  save(scene.text(), options.out);
  if (!options.hand.empty()) save(scene.handFile(), options.hand);
  Report report;
  report.add("scene", options.out);
  report.add("walls",
             static_cast<std::uint64_t>((cells.columns - 1) * (cells.rows - 1) + 2 * (cells.columns + cells.rows)));
  if (!options.hand.empty()) report.add("hand", options.hand);
  report.print(options.json);
  return kGood;
}

int generateRelief(const GenerateOptions& options) {
  const Cells cells = parseCells(options.cells);
  save(reliefScene(cells.columns, cells.rows, static_cast<std::uint64_t>(options.seed)), options.out);
  Report report;
  report.add("scene", options.out);
  report.add("triangles", static_cast<std::uint64_t>(2 * cells.columns * cells.rows));
  report.print(options.json);
  return kGood;
}

void addOptions(const Command& command, GenerateOptions& options) {
  command.text("--cells", options.cells, "Columns and rows, 2 to 1000 each").type("NxM").showDefault();
  command.count("--seed", options.seed, kSeeds, "The same seed gives the same scene").type("S").showDefault();
  command.path("--out", options.out, "The scene to be written").type("FILE.iv").required();
}

}  // namespace

void addGenerateCommand(const Command& program) {
  const Command generate = program.addGroup("generate", "Make a scene by rule and seed");
  const auto maze = std::make_shared<GenerateOptions>();
  maze->cells = "100x100";
  const Command mazeCommand =
      generate.add("maze", "A maze of box walls, a spanning tree; 100x100 cells have 10,201 walls",
                   [maze] { return generateMaze(*maze); });
  addOptions(mazeCommand, *maze);
  mazeCommand.path("--hand", maze->hand, "Write the hand's way through it, too, for haptiv run").type("FILE.csv");
  mazeCommand.json(maze->json);

  const auto relief = std::make_shared<GenerateOptions>();
  relief->cells = "225x225";
  const Command reliefCommand = generate.add("relief", "An island as a mesh of 2 N M triangles, and the sea around it",
                                             [relief] { return generateRelief(*relief); });
  addOptions(reliefCommand, *relief);
  reliefCommand.json(relief->json);
}

}  // namespace haptiv
