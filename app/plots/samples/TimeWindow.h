#pragma once

namespace haptiv {

/// The times that a plot shows, within an extent that holds all there is. Seconds.
class TimeWindow {
 public:
  explicit TimeWindow(double span) : extentTo_(span), to_(span) {}

  double from() const { return from_; }
  double to() const { return to_; }
  bool zoomed() const { return zoomed_; }
  double bounded(double time) const;  ///< into the extent

  /// A window that was not zoomed shows the whole of the new extent.
  void setExtent(double from, double to);
  /// Zooms; moved and cut to fit into the extent.
  void show(double from, double to);
  void showAll();
  /// @param factor  of the span, below 1: nearer; `about` keeps its place
  void zoom(double factor, double about);

 private:
  double extentFrom_ = 0;
  double extentTo_;
  double from_ = 0;
  double to_;
  bool zoomed_ = false;
};

}  // namespace haptiv
