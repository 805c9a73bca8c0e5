#pragma once

#include <QMenu>

#include "device/control/ControlChoice.h"

namespace haptiv {

/// The menu by which the user chooses how the next session drives the arm; docs/control.md. Thread: GUI.
class ControlMenu : public QMenu {
  Q_OBJECT
 public:
  explicit ControlMenu(QWidget* parent = nullptr);

  /// Marks what is chosen; announces nothing.
  void showChoice(const ControlChoice& choice);
  /// Whether the arm's description tells its links as bodies, which computed torque needs.
  void setComputedTorquePossible(bool possible);

 signals:
  /// The user has chosen.
  void chosen(const haptiv::ControlChoice& choice);

 private:
  /// One respect in which there is something to choose: a heading, and an item for each name.
  template <typename Choices>
  QActionGroup* addChoices(const QString& heading, const Choices& choices);
  void announce();

  QActionGroup* display_;
  QActionGroup* joints_;
  QActionGroup* orientation_;
  QAction* passivity_;
};

}  // namespace haptiv
