#pragma once

#include <QPointF>
#include <QVector>
#include <vector>

namespace haptiv {

/// Samples of a few curves over one rising time, and what of them is to be drawn.
class Signals {
 public:
  explicit Signals(std::size_t curves) : samples_(curves) {}

  bool empty() const { return times_.empty(); }
  double firstTime() const { return times_.front(); }  ///< not for empty ones
  double lastTime() const { return times_.back(); }    ///< not for empty ones

  void append(double time, const std::vector<double>& values);
  /// Curves that are missing or too short are filled up with nothing.
  void set(const std::vector<double>& times, const std::vector<std::vector<double>>& samples);
  void clear();
  /// Forgets what lies before this time, but for the last sample there: the line comes from it.
  void dropBefore(double time);

  struct Drawing {
    std::vector<QVector<QPointF>> curves;  ///< finite values only
    double least = 0;
    double greatest = 0;
    bool any = false;
  };
  /// What draws like the samples from `from` to `to` on so many pixel columns: at most about two points a column.
  Drawing draw(double from, double to, std::size_t columns) const;

 private:
  std::vector<double> times_;
  std::vector<std::vector<double>> samples_;
};

}  // namespace haptiv
