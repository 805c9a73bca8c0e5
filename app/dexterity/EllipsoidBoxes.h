#pragma once

#include <QAction>
#include <QWidget>
#include <array>

#include "app/view/ellipsoids/DexterityFigure.h"

namespace haptiv {

/// A box to tick for each manipulability ellipsoid, in the ellipsoid's colour and with the scale of its drawing. The
/// actions do the same and can stand in a menu. Thread: GUI.
class EllipsoidBoxes : public QWidget {
  Q_OBJECT
 public:
  explicit EllipsoidBoxes(QWidget* parent = nullptr);

  QAction* action(Manipulability which) const { return actions_[static_cast<std::size_t>(which)]; }

 signals:
  void switched(haptiv::Manipulability which, bool visible);

 private:
  void add(Manipulability which, const char* name, const QString& title, const QString& legend);

  std::array<QAction*, 2> actions_{};
};

}  // namespace haptiv
