#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Figures as data: what a command wants to show, without Qt. drawFigure turns one into a picture. Texts are UTF-8.
namespace haptiv {

struct FigureAxis {
  std::string label;                                  ///< with the unit, such as "t [s]"
  std::optional<std::pair<double, double>> range;     ///< without it: what is drawn, with some room
  std::vector<std::pair<double, std::string>> ticks;  ///< where round numbers will not do, such as at multiples of pi
};

/// Points with straight lines between them. Points that are not finite leave a gap.
struct FigureCurve {
  std::vector<double> x;
  std::vector<double> y;  ///< as many as x
  int style = 0;          ///< of kLineStyles, counted round
  bool line = true;
  bool markers = false;  ///< a symbol at each point
  bool arrow = false;    ///< an arrow head at the last point
};

/// A word at a place, to the right of it.
struct FigureNote {
  double x = 0;
  double y = 0;
  std::string text;
};

/// A value over a plane, as colours with a bar that explains them.
struct FigureMap {
  std::pair<double, double> x;  ///< from the left edge of the first column to the right of the last
  std::pair<double, double> y;  ///< from the lower edge of the first row to the upper of the last
  int columns = 0;
  std::vector<double> values;                      ///< row by row, each `columns` long; NaN stays white
  std::string label;                               ///< of the bar, with the unit
  std::optional<std::pair<double, double>> range;  ///< of the bar; without it: from the least to the greatest value
};

struct FigurePanel {
  std::string title;
  FigureAxis x;
  FigureAxis y;
  std::vector<FigureCurve> curves;
  std::vector<FigureNote> notes;
  std::optional<FigureMap> map;
  bool equalScales = false;  ///< a metre is as long in x as in y
};

/// A line of the legend: what the curves of this style are.
struct FigureKey {
  std::string text;
  int style = 0;
  bool line = true;
  bool markers = false;
};

struct Figure {
  std::string title;
  std::vector<FigureKey> legend;    ///< stands above the panels, for all of them, and hides nothing
  std::vector<FigurePanel> panels;  ///< row by row
  int columns = 1;
};

}  // namespace haptiv
