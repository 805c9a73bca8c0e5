#include "app/devicecheck/ManipulabilityMap.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace haptiv {
namespace {

constexpr double kSameHeight = 1e-6;  // [m]

struct Index {
  const char* name;
  double PoseFigures::*value;
};

std::string heightText(double z) {
  char text[32];
  std::snprintf(text, sizeof text, "z = %.2f m", z);
  return text;
}

FigurePanel panelOf(const Tour& tour, const TourGrid& grid, double radius, double z, const Index& index) {
  const int half = static_cast<int>(std::floor(radius / grid.lines + 1e-9));
  const double edge = (half + 0.5) * grid.lines;
  FigureMap map{{-edge, edge}, {-edge, edge}, 2 * half + 1, {}, index.name, {}};
  map.values.assign(static_cast<std::size_t>(map.columns) * map.columns, std::numeric_limits<double>::quiet_NaN());
  for (const TourSample& sample : tour.samples) {
    if (!sample.onGrid || std::abs(sample.position.z() - z) > kSameHeight) continue;
    const auto column = std::lround(sample.position.x() / grid.lines) + half;
    const auto row = std::lround(sample.position.y() / grid.lines) + half;
    map.values[static_cast<std::size_t>(row * map.columns + column)] = sample.figures.*index.value;
  }
  FigurePanel panel;
  panel.title = heightText(z);
  panel.x.label = "x [m]";
  panel.y.label = "y [m]";
  panel.map = std::move(map);
  panel.equalScales = true;
  return panel;
}

/// One scale for all panels of an index.
void shareRange(std::vector<FigurePanel>& panels, std::size_t first) {
  double most = 0;
  for (std::size_t i = first; i < panels.size(); ++i) {
    for (const double value : panels[i].map->values)
      if (std::isfinite(value)) most = std::max(most, value);
  }
  if (most == 0) return;
  for (std::size_t i = first; i < panels.size(); ++i) panels[i].map->range = {0, most};
}

}  // namespace

Figure manipulabilityMap(const Tour& tour, const TourGrid& grid, const Specification& specification,
                         const std::string& title) {
  const Index indices[] = {{"V/\u03ba, translation [m\u00b3]", &PoseFigures::indexTranslation},
                           {"V/\u03ba, rotation", &PoseFigures::indexRotation}};
  Figure figure;
  figure.title = title;
  figure.columns = 3;
  for (const Index& index : indices) {
    const std::size_t first = figure.panels.size();
    for (const double z : {-specification.height / 2, 0., specification.height / 2})
      figure.panels.push_back(panelOf(tour, grid, specification.diameter / 2, z, index));
    shareRange(figure.panels, first);
  }
  return figure;
}

}  // namespace haptiv
