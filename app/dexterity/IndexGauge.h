#pragma once

#include <QLabel>
#include <QWidget>

#include "device/redundancy/criterion/Criterion.h"

namespace haptiv {

/// Dexterity in translation or in rotation: the index m = V / kappa, normalised so that 1 is the average best that
/// self-motion reaches, as a bar; below it condition number and smallest singular value. Near a singularity a word
/// says so and all turns amber, then red. Thread: GUI.
class IndexGauge : public QWidget {
 public:
  static constexpr double kNear = 10;      ///< condition number from which a pose is called near a singularity
  static constexpr double kSingular = 50;  ///< and from which it is called singular

  /// @param unit  of the tool's speed, such as "m/s"
  IndexGauge(const QString& title, const QString& unit, QWidget* parent = nullptr);

  /// @param best  the index's normalisation; where it is not positive there is no bar
  void show(const Dexterity& dexterity, double best);

 private:
  class Bar;
  QString unit_;
  QLabel* warning_;
  QLabel* share_;
  Bar* bar_;
  QLabel* details_;
};

}  // namespace haptiv
