#pragma once

namespace haptiv {

/// The range of a value axis that stays where it is as long as the values fit in it and fill it fairly: round ends, and
/// never narrower than a span that has meaning, so that noise is not blown up to full height.
class CalmRange {
 public:
  /// @param minimumSpan  in the unit of the values, > 0
  explicit CalmRange(double minimumSpan = 1);

  /// Makes room for values from `least` to `greatest`. Widens at once, narrows only where much would be empty.
  void fit(double least, double greatest);
  /// Forgets what was shown: the next fit starts anew.
  void reset();

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  double step() const { return step_; }  ///< between two labels

 private:
  double minimumSpan_;
  bool set_ = false;
  double lower_ = 0;
  double upper_ = 1;
  double step_ = 0.5;
};

}  // namespace haptiv
