#include "app/generate/Maze.h"

#include <algorithm>
#include <random>

namespace haptiv {

Maze::Maze(int columns, int rows, std::uint64_t seed) : columns_(columns), rows_(rows) {
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  openEast_.assign(count, false);
  openNorth_.assign(count, false);
  std::vector<bool> dug(count, false);
  std::mt19937_64 random(seed);
  std::vector<MazeCell> trail = {{0, 0}};
  dug[0] = true;
  while (!trail.empty()) {
    std::vector<MazeCell> ahead = neighbours(trail.back());
    std::erase_if(ahead, [&](MazeCell cell) { return dug[indexOf(cell)]; });
    if (ahead.empty()) {
      trail.pop_back();
      continue;
    }
    const MazeCell next = ahead[random() % ahead.size()];
    open(trail.back(), next);
    dug[indexOf(next)] = true;
    trail.push_back(next);
  }
}

std::vector<MazeCell> Maze::way(MazeCell from, MazeCell to) const {
  std::vector<MazeCell> before(openEast_.size(), MazeCell{-1, -1});
  std::vector<MazeCell> reached = {to};
  before[indexOf(to)] = to;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const MazeCell next : neighbours(reached[i])) {
      if (!isOpen(reached[i], next) || before[indexOf(next)].column >= 0) continue;
      before[indexOf(next)] = reached[i];
      reached.push_back(next);
    }
  }
  std::vector<MazeCell> way = {from};
  while (!(way.back() == to)) way.push_back(before[indexOf(way.back())]);
  return way;
}

std::vector<MazeCell> Maze::neighbours(MazeCell cell) const {
  std::vector<MazeCell> all = {{cell.column - 1, cell.row},
                               {cell.column + 1, cell.row},
                               {cell.column, cell.row - 1},
                               {cell.column, cell.row + 1}};
  std::erase_if(all, [&](MazeCell next) {
    return next.column < 0 || next.row < 0 || next.column >= columns_ || next.row >= rows_;
  });
  return all;
}

bool Maze::isOpen(MazeCell from, MazeCell to) const {
  const MazeCell first{std::min(from.column, to.column), std::min(from.row, to.row)};
  return from.row == to.row ? !hasWallEast(first) : !hasWallNorth(first);
}

void Maze::open(MazeCell from, MazeCell to) {
  const MazeCell first{std::min(from.column, to.column), std::min(from.row, to.row)};
  (from.row == to.row ? openEast_ : openNorth_)[indexOf(first)] = true;
}

}  // namespace haptiv
