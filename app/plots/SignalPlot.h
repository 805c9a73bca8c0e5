#pragma once

#include <QWidget>
#include <memory>
#include <vector>

namespace haptiv {

/// A plot of a few signals over time: for a running session (it rolls) and for a replay (it stands, with a cursor).
class SignalPlot : public QWidget {
  Q_OBJECT
 public:
  /// @param title  with the unit, such as "force [N]"
  /// @param names  one a curve, such as {"x", "y", "z", "norm"}
  SignalPlot(const QString& title, const std::vector<QString>& names, QWidget* parent = nullptr);
  ~SignalPlot() override;

  /// Live: adds one sample to each curve and shows the last `kWindow` seconds.
  void append(double time, const std::vector<double>& values);
  static constexpr double kWindow = 10;  ///< [s]
  /// Replay: shows whole curves; samples[i] belongs to names[i].
  void setCurves(const std::vector<double>& times, const std::vector<std::vector<double>>& samples);
  void setCursor(double time);
  void clear();

 signals:
  /// The user clicked or dragged in a standing plot.
  void timePicked(double time);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
