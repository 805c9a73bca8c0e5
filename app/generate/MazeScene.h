#pragma once

#include <string>

#include "app/generate/Maze.h"

namespace haptiv {

/// A maze as a scene, and as a hand's way through it.
///
/// Each wall of a cell's length is a box of its own; corridors are 5 cm wide, walls 2 cm thick and 4 cm high, all in
/// one plane. The ball starts in the south-west, a viscous zone fills the cell in the north-east. A maze that is larger
/// than the arm reaches well stands on a device with a scale, and mass, damping and stiffness are divided by it, so
/// that the hand feels the same.
class MazeScene {
 public:
  MazeScene(Maze maze, std::uint64_t seed);

  /// Inventor text, with comments.
  std::string text() const;
  /// A hand file, t,x,y,z: from the start to the goal, at the middle of the corridors, at 5 cm/s of the device.
  std::string handFile() const;

 private:
  struct Box {
    double x, y;
    bool along;  ///< along x; else along y
  };
  std::vector<Box> walls(bool outer) const;
  std::string headText() const;
  std::string deviceText() const;
  std::string floorText() const;
  std::string wallsText() const;
  std::string boxesText(bool outer) const;
  std::string goalText() const;
  double x(double column) const;
  double y(double row) const;
  double mass() const;  ///< of the tool [kg]

  Maze maze_;
  std::uint64_t seed_;
  double scale_;
};

}  // namespace haptiv
