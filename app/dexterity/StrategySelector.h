#pragma once

#include <QComboBox>
#include <QWidget>

#include "device/control/ResolutionChoice.h"

namespace haptiv {

/// Strategy and solution of the redundancy, chosen by name. Thread: GUI.
class StrategySelector : public QWidget {
  Q_OBJECT
 public:
  explicit StrategySelector(QWidget* parent = nullptr);

  /// Shows a choice without announcing it.
  void show(const ResolutionChoice& choice);
  /// Only VISHARD10 has a partitioned solution.
  void setPartitionedPossible(bool possible);

 signals:
  /// By the user.
  void chosen(const haptiv::ResolutionChoice& choice);

 private:
  void announce();

  QComboBox* strategy_;
  QComboBox* solution_;
};

}  // namespace haptiv
