#pragma once

#include <QMenu>
#include <optional>

#include "app/session/hands/SpaceMouseChoice.h"

class QActionGroup;

namespace haptiv {

/// What the operator of the simulated arm holds; nothing: the mouse.
using HandInput = std::optional<SpaceMouseChoice>;

/// The menu by which the user chooses what moves the hand in the next session: the mouse, or a SpaceMouse; where
/// several are plugged in, which. It looks for them whenever it is opened. Thread: GUI.
class HandMenu : public QMenu {
  Q_OBJECT
 public:
  explicit HandMenu(QWidget* parent = nullptr);

  bool isMouse() const { return !mode_; }  ///< the computer's: no SpaceMouse

 signals:
  void chosen(const haptiv::HandInput& input);

 private:
  void refresh();
  void offerWay(const char* name, const QString& text, std::optional<SpaceMouseHand::Mode> mode);
  void offerMouse(const QString& which, const QString& text, const QString& trouble);
  void tell();

  QActionGroup *ways_, *mice_;
  std::optional<SpaceMouseHand::Mode> mode_;  // nothing: the mouse
  QString which_;                             // SpaceMouse; empty: the only one
};

}  // namespace haptiv
