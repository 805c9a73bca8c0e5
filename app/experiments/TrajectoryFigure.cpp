#include "app/experiments/TrajectoryFigure.h"

#include <cmath>
#include <numbers>

#include "app/experiments/RunSetup.h"
#include "device/kinematics/Vishard10.h"

namespace haptiv {
namespace {

FigureCurve arc(const Vector3& centre, double radius, int style) {
  constexpr int kPieces = 240;
  FigureCurve curve;
  curve.style = style;
  for (int i = 0; i <= kPieces; ++i) {
    curve.x.push_back(centre.x() + radius * std::cos(2 * std::numbers::pi * i / kPieces));
    curve.y.push_back(centre.y() - radius * std::sin(2 * std::numbers::pi * i / kPieces));
  }
  return curve;
}

}  // namespace

Figure trajectoryFigure(const DeviceDescription& device) {
  constexpr double kWorkspaceRadius = 0.85;  // [m]  [paper, Table II]
  const RunSetup run = heightRun(device, {}, kHeights[0]);
  Figure figure;
  figure.title = "Circular trajectory of the heights and velocities, seen from +z";
  figure.legend = {{"path, r = 0.4 m", 2}, {"workspace, 1.7 m wide", 6}, {"arm at the start", 0, true, true}};
  FigurePanel& panel = figure.panels.emplace_back();
  panel.x = {"x [m]", std::pair(-0.95, 0.95), {}};
  panel.y = {"y [m]", std::pair(-0.95, 0.95), {}};
  panel.equalScales = true;
  panel.curves.push_back(arc(Vector3::Zero(), kWorkspaceRadius, 6));

  FigureCurve links;  // the four links in the plane, joint 1 to joint 5
  const auto places = Vishard10(device.links).skeleton(run.startAngles).at;
  for (std::size_t i = 0; i < 5; ++i) {
    links.x.push_back(places[i].x());
    links.y.push_back(places[i].y());
  }
  links.markers = true;
  panel.curves.push_back(links);
  FigureCurve path = arc(run.path.centre, run.path.radius, 2);
  panel.curves.push_back(path);
  FigureCurve sense = path;  // its first eighth, for the arrow
  sense.x.resize(31);
  sense.y.resize(31);
  sense.arrow = true;
  panel.curves.push_back(sense);
  FigureCurve start;
  start.x = {0.8};
  start.y = {0};
  start.style = 2;
  start.markers = true;
  panel.curves.push_back(start);
  panel.notes = {{0.8, -0.06, ""}, {0, -0.06, "joint axis 1"}, {0.8, 0.05, "start"}};
  return figure;
}

}  // namespace haptiv
