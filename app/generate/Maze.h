#pragma once

#include <cstdint>
#include <vector>

namespace haptiv {

/// A place in a maze: column from the west, row from the south, from 0.
struct MazeCell {
  int column = 0;
  int row = 0;
  bool operator==(const MazeCell&) const = default;
};

/// A maze of columns x rows cells in which exactly one way leads from each cell to each other: a spanning tree, dug by
/// a random walk that turns back where it is caught. (columns - 1)(rows - 1) walls, of a cell's length each, stand
/// between its cells.
///
/// The same numbers give the same maze on every machine: of std::mt19937_64, which the standard fixes, the next number
/// modulo the number of neighbours not yet dug, which are counted west, east, south, north.
class Maze {
 public:
  Maze(int columns, int rows, std::uint64_t seed);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Whether a wall stands between a cell and its neighbour; around the maze there always is one.
  bool hasWallEast(MazeCell cell) const { return cell.column + 1 == columns_ || !openEast_[indexOf(cell)]; }
  bool hasWallNorth(MazeCell cell) const { return cell.row + 1 == rows_ || !openNorth_[indexOf(cell)]; }

  /// The only way, both ends included.
  std::vector<MazeCell> way(MazeCell from, MazeCell to) const;

 private:
  std::size_t indexOf(MazeCell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cell.column);
  }
  std::vector<MazeCell> neighbours(MazeCell cell) const;
  bool isOpen(MazeCell from, MazeCell to) const;
  void open(MazeCell from, MazeCell to);

  int columns_;
  int rows_;
  std::vector<bool> openEast_, openNorth_;
};

}  // namespace haptiv
