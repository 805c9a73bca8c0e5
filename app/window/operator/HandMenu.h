#pragma once

#include <QMenu>
#include <optional>

#include "app/session/hands/SpaceMouseChoice.h"
#include "app/window/operator/DeviceWatch.h"

class QActionGroup;

namespace haptiv {

/// What the operator of the simulated arm holds; nothing: the mouse.
using HandInput = std::optional<SpaceMouseChoice>;

/// The menu by which the user chooses what moves the hand in the next session: the mouse, or a SpaceMouse; where
/// several are plugged in, which. It shows what the watch knows and, open or not, follows it. Thread: GUI.
class HandMenu : public QMenu {
  Q_OBJECT
 public:
  /// @param watch  is there as long as this is used
  explicit HandMenu(DeviceWatch& watch, QWidget* parent = nullptr);

  bool isMouse() const { return !mode_; }  ///< the computer's: no SpaceMouse

 signals:
  void chosen(const haptiv::HandInput& input);

 private:
  void refresh();
  void listMice();
  void offerWay(const char* name, const QString& text, std::optional<SpaceMouseHand::Mode> mode);
  void offerMouse(const QString& which, const QString& text, const QString& trouble);
  void tell();

  DeviceWatch& watch_;
  QActionGroup *ways_, *mice_;
  std::optional<SpaceMouseHand::Mode> mode_;  // nothing: the mouse
  QString which_;                             // SpaceMouse; empty: the only one
};

}  // namespace haptiv
