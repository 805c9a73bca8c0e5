#include "app/bench/wall/WallFigure.h"

#include <algorithm>
#include <cmath>

#include "device/control/ControlNames.h"

namespace haptiv {
namespace {

constexpr double kBrightest = 5;  // [N]
constexpr int kOptimumStyle = 4;
constexpr const char* kVariantKeys[] = {"limit of the law", "with hysteresis", "damped both ways",
                                        "with passivity control"};

/// From the lower edge of the first cell to the upper of the last, as powers of ten.
std::pair<double, double> edges(const std::vector<double>& values) {
  const double half = 0.5 * std::log10(values[1] / values[0]);
  return {std::log10(values.front()) - half, std::log10(values.back()) + half};
}

FigureAxis decades(const std::string& label, const std::pair<double, double>& range) {
  FigureAxis axis{label, range, {}};
  for (double power = std::ceil(range.first); power <= range.second; ++power) {
    std::string number = "1";
    number.append(static_cast<std::size_t>(std::max(0.0, power)), '0');
    if (number.size() > 4) {
      for (std::size_t left = number.size(); left > 3; left -= 3) number.insert(left - 3, " ");
    }
    axis.ticks.emplace_back(power, number);
  }
  return axis;
}

FigureMap coloursOf(const WallMap& map, const WallShaking& shaking) {
  FigureMap colours;
  colours.x = edges(map.damping);
  colours.y = edges(map.stiffness);
  colours.columns = static_cast<int>(map.damping.size());
  for (const double oscillation : shaking.oscillation)
    colours.values.push_back(std::isfinite(oscillation) ? std::min(oscillation, kBrightest) : NAN);
  colours.label = "shaking of the law's wall [N], white: contact lost or fault";
  colours.range = std::pair(0., kBrightest);
  return colours;
}

/// A little below the upper edge where all are stable, at the lower edge where none is.
FigureCurve limitCurve(const WallMap& map, const WallLimit& limit) {
  const auto [low, high] = edges(map.stiffness);
  FigureCurve curve;
  curve.style = static_cast<int>(limit.variant);
  curve.markers = true;
  for (std::size_t i = 0; i < limit.stiffness.size(); ++i) {
    curve.x.push_back(std::log10(map.damping[i]));
    curve.y.push_back(std::clamp(std::log10(limit.stiffness[i]), low, high));
  }
  return curve;
}

FigureCurve optimumCurve(const WallMap& map) {
  const auto [low, high] = edges(map.stiffness);
  const auto dampingAt = [&](double logStiffness) {
    return 0.5 * (std::log10(2 * map.mass) + logStiffness);  // (33) for b
  };
  FigureCurve curve;
  curve.style = kOptimumStyle;
  const auto [first, last] = edges(map.damping);
  for (const double y : {low, high}) {
    const double x = std::clamp(dampingAt(y), first, last);
    curve.x.push_back(x);
    curve.y.push_back(2 * x - std::log10(2 * map.mass));
  }
  return curve;
}

}  // namespace

Figure wallFigure(const WallMap& map) {
  Figure figure;
  std::string rate = std::to_string(std::lround(map.rate));
  figure.title = "Stable walls: " + map.device + " at " + rate + " Hz, " + nameOf(map.control.display) + ", " +
                 (map.control.display == DisplayMode::impedance ? "the arm's own mass"
                                                                : nameOf(map.control.joints) + ", virtual mass 2 kg");
  figure.columns = static_cast<int>(map.shaking.size());
  for (const WallVariant variant : kWallVariants) {
    const int style = static_cast<int>(variant);
    figure.legend.push_back({kVariantKeys[style], style, true, true});
  }
  figure.legend.push_back({"optimal stiffness k = b²/2m (33)", kOptimumStyle});
  for (const WallShaking& shaking : map.shaking) {
    FigurePanel panel;
    panel.title = shaking.grip + " grip";
    panel.x = decades("damping b [N s/m]", edges(map.damping));
    panel.y = decades("stiffness k [N/m]", edges(map.stiffness));
    panel.map = coloursOf(map, shaking);
    for (const WallLimit& limit : map.limits) {
      if (limit.grip == shaking.grip) panel.curves.push_back(limitCurve(map, limit));
    }
    panel.curves.push_back(optimumCurve(map));
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

}  // namespace haptiv
