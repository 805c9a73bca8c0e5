#include "app/generate/MazeScene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/generate/SceneText.h"

namespace haptiv {
namespace {

constexpr double kCorridor = 0.05;   // [m], as all lengths here
constexpr double kThickness = 0.02;  // of the walls
constexpr double kHeight = 0.04;
constexpr double kPitch = kCorridor + kThickness;
constexpr double kBall = 0.01;
constexpr double kRoom = 0.66;       // side of the square that the arm reaches well ...
constexpr double kAhead = 0.42;      // ... whose middle is so far before its base
constexpr double kMass = 2;          // as the hand feels them, at scale 1 [kg]
constexpr double kDamping = 5;       // [N s/m]
constexpr double kSpeed = 0.05;      // of the hand, at scale 1 [m/s]
constexpr double kStiffness = 9000;  // in the scene: 170 N press 19 mm deep, less than the thickness [N/m]
constexpr double kSettle = 1;        // before the hand sets out [s]

}  // namespace

MazeScene::MazeScene(Maze maze, std::uint64_t seed)
    : maze_(std::move(maze)),
      seed_(seed),
      scale_(std::max(1.0, std::max(maze_.columns(), maze_.rows()) * kPitch / kRoom)) {}

double MazeScene::x(double column) const {
  return (column - maze_.columns() / 2.0) * kPitch;
}

double MazeScene::y(double row) const {
  return (row - maze_.rows() / 2.0) * kPitch;
}

double MazeScene::mass() const {
  return kMass / scale_;
}

std::vector<MazeScene::Box> MazeScene::walls(bool outer) const {
  std::vector<Box> boxes;
  for (int row = 0; row < maze_.rows(); ++row) {
    for (int column = 0; column < maze_.columns(); ++column) {
      const MazeCell cell{column, row};
      if (outer && column == 0) boxes.push_back({x(0), y(row + 0.5), false});
      if (outer && row == 0) boxes.push_back({x(column + 0.5), y(0), true});
      const bool isLastColumn = column + 1 == maze_.columns();
      const bool isLastRow = row + 1 == maze_.rows();
      if (isLastColumn == outer && maze_.hasWallEast(cell)) boxes.push_back({x(column + 1), y(row + 0.5), false});
      if (isLastRow == outer && maze_.hasWallNorth(cell)) boxes.push_back({x(column + 0.5), y(row + 1), true});
    }
  }
  return boxes;
}

std::string MazeScene::boxesText(bool outer) const {
  std::string text;
  for (const Box& box : walls(outer)) {
    text += "  Separator { Translation { translation " + sceneNumbers({box.x, box.y, kHeight / 2}) + " } USE ";
    text += box.along ? "along_x }\n" : "along_y }\n";
  }
  return text;
}

std::string MazeScene::text() const {
  return headText() + deviceText() + floorText() + wallsText() + goalText();
}

std::string MazeScene::headText() const {
  const std::string size = std::to_string(maze_.columns()) + "x" + std::to_string(maze_.rows());
  return "#Inventor V2.1 ascii\n\n# A maze of " + size +
         " cells with one way from each cell to each other:\n#   haptiv generate maze --cells " + size + " --seed " +
         std::to_string(seed_) +
         " --out FILE.iv\n# The ball starts in the south-west; the goal, in the north-east, is filled with "
         "something viscous.\n# Metres, newtons, seconds; z points up.\n\n";
}

std::string MazeScene::deviceText() const {
  const std::string device =
      "# A hand of the device moves the ball " + sceneNumber(scale_) +
      " times as far. Mass, damping and stiffness are felt so many times as well: what\n# stands here is divided by "
      "it.\nHapticDevice {\n  description \"vishard10\"\n  position " +
      sceneNumbers({0, -kAhead * scale_, kHeight / 2}) + "\n  orientation 0 0 1 1.5707963\n  scale " +
      sceneNumber(scale_) + "\n}\n\n";
  return device + "HapticTool {\n  mass " + sceneNumber(mass()) + "\n  damping " + sceneNumber(kDamping / scale_) +
         "\n  radius " + sceneNumber(kBall) + "\n  home " + sceneNumbers({x(0.5), y(0.5), kHeight / 2}) + "\n}\n\n";
}

std::string MazeScene::floorText() const {
  return "# The floor is seen and not felt.\nSeparator {\n  Translation { translation 0 0 -0.005 }\n  Material { "
         "diffuseColor 0.93 0.92 0.88 }\n  Cube { width " +
         sceneNumber(maze_.columns() * kPitch + kThickness) + " height " +
         sceneNumber(maze_.rows() * kPitch + kThickness) + " depth 0.01 }\n}\n\n";
}

std::string MazeScene::wallsText() const {
  const std::string length = sceneNumber(kPitch + kThickness);
  const std::string thickness = sceneNumber(kThickness);
  const std::string height = sceneNumber(kHeight);
  const std::string surface = "HapticSurface { stiffness " + sceneNumber(kStiffness) + " damping " +
                              sceneNumber(std::round(std::sqrt(2 * mass() * kStiffness) * 10) / 10);
  const std::string kinds = "# The two walls that all are made of: each " + length + " m long, " + thickness +
                            " m thick.\nSwitch {\n  DEF along_x Cube { width " + length + " height " + thickness +
                            " depth " + height + " }\n  DEF along_y Cube { width " + thickness + " height " + length +
                            " depth " + height + " }\n}\n\n";
  const std::string frame = "DEF frame Separator {\n  " + surface +
                            " label \"frame\" }\n  Material { diffuseColor 0.56 0.62 0.70 }\n" + boxesText(true) +
                            "}\n\n";
  return kinds + frame + "DEF walls Separator {\n  " + surface +
         " label \"walls\" }   # the damping is the optimal one, b^2 = 2 m k\n  Material { diffuseColor 0.70 0.75 "
         "0.82 }\n" +
         boxesText(false) + "}\n\n";
}

std::string MazeScene::goalText() const {
  return "DEF goal Separator {\n  HapticViscousZone { damping " + sceneNumber(30 / scale_) +
         " label \"goal\" }\n  Translation { translation " +
         sceneNumbers({x(maze_.columns() - 0.5), y(maze_.rows() - 0.5), kHeight / 2}) +
         " }\n  Material { diffuseColor 0.92 0.70 0.32 transparency 0.4 }\n  Cube { width 0.05 height 0.05 depth " +
         sceneNumber(kHeight) + " }\n}\n";
}

std::string MazeScene::handFile() const {
  std::string text = "t,x,y,z\n";
  double time = 0;
  for (const MazeCell cell : maze_.way({0, 0}, {maze_.columns() - 1, maze_.rows() - 1})) {
    const std::string place = sceneNumber(x(cell.column + 0.5)) + "," + sceneNumber(y(cell.row + 0.5)) + "," +
                              sceneNumber(kHeight / 2) + "\n";
    text += sceneNumber(time) + "," + place;
    if (time == 0) text += sceneNumber(time = kSettle) + "," + place;
    time += kPitch / (kSpeed * scale_);
  }
  return text;
}

}  // namespace haptiv
