#include "app/generate/Maze.h"

#include <gtest/gtest.h>

namespace haptiv {
namespace {

struct Size {
  int columns, rows;
};

class MazeOf : public ::testing::TestWithParam<Size> {};

TEST_P(MazeOf, HasAsManyWallsAsATreeLeaves) {
  const Maze maze(GetParam().columns, GetParam().rows, 3);
  int inner = 0;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      if (column + 1 < maze.columns() && maze.hasWallEast({column, row})) ++inner;
      if (row + 1 < maze.rows() && maze.hasWallNorth({column, row})) ++inner;
    }
  }
  EXPECT_EQ(inner, (maze.columns() - 1) * (maze.rows() - 1));
}

TEST_P(MazeOf, LeadsFromTheFirstCellToEveryOther) {
  const Maze maze(GetParam().columns, GetParam().rows, 4);
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const auto way = maze.way({0, 0}, {column, row});
      ASSERT_EQ(way.front(), (MazeCell{0, 0}));
      ASSERT_EQ(way.back(), (MazeCell{column, row}));
      for (std::size_t i = 1; i < way.size(); ++i) {
        const MazeCell a = way[i - 1];
        const MazeCell b = way[i];
        const bool isStepEast = a.row == b.row && std::abs(a.column - b.column) == 1;
        const bool isStepNorth = a.column == b.column && std::abs(a.row - b.row) == 1;
        ASSERT_TRUE(isStepEast || isStepNorth);
        const MazeCell first{std::min(a.column, b.column), std::min(a.row, b.row)};
        ASSERT_FALSE(isStepEast ? maze.hasWallEast(first) : maze.hasWallNorth(first));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, MazeOf, ::testing::Values(Size{2, 2}, Size{2, 17}, Size{13, 9}), [](const auto& one) {
  return std::to_string(one.param.columns) + "x" + std::to_string(one.param.rows);
});

TEST(Maze, IsAnotherForAnotherSeed) {
  const auto wayOf = [](std::uint64_t seed) { return Maze(20, 20, seed).way({0, 0}, {19, 19}); };
  EXPECT_EQ(wayOf(1), wayOf(1));
  EXPECT_NE(wayOf(1), wayOf(2));
}

}  // namespace
}  // namespace haptiv
