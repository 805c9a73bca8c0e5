#include "app/generate/ReliefScene.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "app/generate/SceneText.h"

namespace haptiv {
namespace {

constexpr double kSide = 0.4;    // of the island's square [m]
constexpr double kPeak = 0.075;  // above the bottom of the sea [m]
constexpr double kSea = 0.016;   // its level
constexpr int kHills = 40;

struct Hill {
  double x, y, height, width;
};

/// From 0 to 1, of a generator that the standard fixes; its distributions are not fixed.
double next(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

std::vector<Hill> makeHills(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Hill> hills = {{0, 0, 0.35, 0.13}};  // what all others stand on
  for (int i = 0; i < kHills; ++i) {
    const double angle = 2 * 3.14159265358979 * next(random);
    const double away = 0.15 * std::sqrt(next(random));
    const double width = 0.008 + 0.035 * next(random) * next(random);
    const double height = (next(random) < 0.25 ? -0.25 : 0.5) * (0.3 + next(random)) * std::sqrt(width / 0.04);
    hills.push_back({away * std::cos(angle), away * std::sin(angle), height, width});
  }
  return hills;
}

double heightAt(const std::vector<Hill>& hills, double x, double y) {
  double sum = 0;
  for (const Hill& hill : hills) {
    const double dx = (x - hill.x) / hill.width;
    const double dy = (y - hill.y) / hill.width;
    sum += hill.height * std::exp(-(dx * dx + dy * dy) / 2);
  }
  return sum;
}

/// Where a column stands from west to east [m].
double along(int column, int columns) {
  return kSide * (1.0 * column / columns - 0.5);
}

/// Heights row by row, from the north (so that a QuadMesh of them faces upwards), scaled so that the highest is kPeak.
std::vector<double> makeHeights(int columns, int rows, std::uint64_t seed) {
  const std::vector<Hill> hills = makeHills(seed);
  std::vector<double> heights;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double height = heightAt(hills, along(column, columns), -along(row, rows));
      heights.push_back(std::max(0.0, height));
    }
  }
  const double highest = *std::max_element(heights.begin(), heights.end());
  for (double& height : heights) height *= kPeak / highest;
  return heights;
}

// Colours from the bottom of the sea to the peak, as a picture of one column.
constexpr const char* kStrata =
    "0x7a6a55 0xb39b6d 0xd9c08a 0xe6d3a0 0x8fae5c 0x6f9a4c 0x5d8a45 0x55803f 0x66813f 0x7d8350 0x8a7f63 0x8f8577 "
    "0x99948c 0xb5b3b0 0xd8d8d8 0xf4f4f4";

}  // namespace

std::string reliefScene(int columns, int rows, std::uint64_t seed) {
  const std::string size = std::to_string(columns) + "x" + std::to_string(rows);
  std::string text = "#Inventor V2.1 ascii\n\n# An island to explore with the ball, a mesh of " +
                     std::to_string(2LL * columns * rows) + " triangles:\n#   haptiv generate relief --cells " + size +
                     " --seed " + std::to_string(seed) +
                     " --out FILE.iv\n# The ball starts above the peak. Metres, newtons, seconds; z points up.\n\n";
  text += "HapticDevice { description \"vishard10\" position 0 -0.35 " + sceneNumber(kPeak) +
          " orientation 0 0 1 1.5707963 }\n\nHapticTool { mass 2 damping 5 radius 0.005 home 0 0 " +
          sceneNumber(kPeak + 0.02) + " }\n\n";
  text +=
      "DEF island Separator {\n  HapticSurface { stiffness 3000 damping 110 label \"island\" }   # N/m, N s/m: b^2 = 2 "
      "m k\n  Material { diffuseColor 1 1 1 ambientColor 0.5 0.5 0.5 }\n  # Coloured by height: the picture is one "
      "column, from the bottom of the sea to the peak.\n  Texture2 { wrapS CLAMP wrapT CLAMP image 1 16 3\n    ";
  text += std::string(kStrata) + " }\n  TextureCoordinatePlane { directionS 0.001 0 0 directionT 0 0 " +
          sceneNumber(1 / kPeak) + " }\n  Coordinate3 { point [\n";
  const std::vector<double> heights = makeHeights(columns, rows, seed);
  std::size_t at = 0;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column, ++at) {
      text +=
          sceneNumbers({along(column, columns), -along(row, rows), heights[at]}) + (column == columns ? ",\n" : ",");
    }
  }
  text += "  ] }\n  QuadMesh { verticesPerRow " + std::to_string(columns + 1) + " verticesPerColumn " +
          std::to_string(rows + 1) + " }\n}\n\n";
  text +=
      "DEF sea Separator {\n  HapticViscousZone { damping 15 label \"sea\" }   # N s/m\n  Translation { translation 0 "
      "0 " +
      sceneNumber(kSea / 2) + " }\n  Material { diffuseColor 0.20 0.47 0.72 transparency 0.45 }\n  Cube { width " +
      sceneNumber(kSide) + " height " + sceneNumber(kSide) + " depth " + sceneNumber(kSea) + " }\n}\n";
  return text;
}

}  // namespace haptiv
