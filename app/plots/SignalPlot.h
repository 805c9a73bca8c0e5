#pragma once

#include <QWidget>
#include <memory>
#include <utility>
#include <vector>

namespace haptiv {

/// A plot of a few signals over time: for a running session (it rolls) and for a replay (it stands, with a cursor).
///
/// A standing plot can be searched with the mouse: click or drag picks a time, the wheel zooms the time about the
/// pointer, a double click shows all. Values that are not finite are left out.
class SignalPlot : public QWidget {
  Q_OBJECT
 public:
  /// @param title  with the unit, such as "force [N]"
  /// @param names  one a curve, such as {"x", "y", "z", "norm"}
  SignalPlot(const QString& title, const std::vector<QString>& names, QWidget* parent = nullptr);
  ~SignalPlot() override;

  /// The value axis never spans less than this, in the unit of the values, > 0.
  void setMinimumSpan(double span);
  /// What stands in the middle while there is nothing to show.
  void setEmptyText(const QString& text);

  /// Live: adds one sample to each curve and shows the last `kWindow` seconds. Draws at most once an event-loop turn.
  /// A time before the last one starts anew.
  void append(double time, const std::vector<double>& values);
  static constexpr double kWindow = 10;  ///< [s]

  /// Replay: shows whole curves; samples[i] belongs to names[i]. Where the user has zoomed to stays.
  void setCurves(const std::vector<double>& times, const std::vector<std::vector<double>>& samples);
  /// Replay: the times that "all" means; without it, those of the curves.
  void setExtent(double from, double to);
  /// Replay: zooms to these times, bounded by the extent.
  void setTimeRange(double from, double to);
  std::pair<double, double> timeRange() const;  ///< what is shown [s]
  void setCursor(double time);
  double cursor() const;  ///< [s]
  /// Back to the empty plot.
  void clear();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The user clicked or dragged in a standing plot.
  void timePicked(double time);
  /// The user zoomed in a standing plot.
  void timeRangeChanged(double from, double to);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void replotSoon();
  void replot();
  void placeCursor();
  bool mouse(QEvent* event);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
