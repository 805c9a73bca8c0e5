#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace haptiv {

/// A few curves over one time, thinned so that a plot of them looks the same: of each bucket of samples the least and
/// the greatest value of each curve stay, in the order in which they came. Values that are not finite are left out.
class Envelope {
 public:
  /// @param bucket  samples that become two; 1 or 2: all samples stay as they are
  Envelope(std::size_t curves, std::size_t bucket);

  /// @param values  one a curve
  void add(double time, std::span<const double> values);
  /// Closes the bucket that is being filled; adding may go on.
  void finish();

  const std::vector<double>& times() const { return times_; }
  /// samples()[i][k] is the value of curve i at times()[k]; NaN where a bucket had no finite value.
  const std::vector<std::vector<double>>& samples() const { return samples_; }

 private:
  struct Extremes {
    double first = 0;  ///< of the two extremes the one that came first
    double second = 0;
    bool any = false;
    void take(double value);
  };

  std::size_t bucket_;
  std::size_t filled_ = 0;
  double bucketStart_ = 0;
  double bucketEnd_ = 0;
  std::vector<Extremes> extremes_;
  std::vector<double> times_;
  std::vector<std::vector<double>> samples_;
};

}  // namespace haptiv
