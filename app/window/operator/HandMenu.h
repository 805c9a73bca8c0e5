#pragma once

#include <QMenu>
#include <optional>

#include "app/session/hands/SpaceMouseHand.h"

namespace haptiv {

/// What the operator of the simulated arm holds; nothing: the mouse.
using HandInput = std::optional<SpaceMouseHand::Mode>;

/// The menu by which the user chooses what moves the hand in the next session: the mouse, or a SpaceMouse. Thread: GUI.
class HandMenu : public QMenu {
  Q_OBJECT
 public:
  explicit HandMenu(QWidget* parent = nullptr);

 signals:
  void chosen(const haptiv::HandInput& input);

 private:
  void add(QActionGroup* group, const char* name, const QString& text, const HandInput& input);
};

}  // namespace haptiv
