#include "app/window/operator/OperatorKeys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include "device/safety/SafetySignals.h"

namespace haptiv {
namespace {

constexpr int kResetPress = 150;  // [ms], many ticks at any rate

}  // namespace

OperatorKeys::OperatorKeys(QWidget& window) : QObject(&window), window_(window) {
  resetPress_.setSingleShot(true);
  resetPress_.setInterval(kResetPress);
  connect(&resetPress_, &QTimer::timeout, this, [this] { set(kInputReset, false); });
  qApp->installEventFilter(this);
}

void OperatorKeys::setActive(bool active) {
  active_ = active;
  inputs_ = 0;
  resetPress_.stop();
}

void OperatorKeys::stopAtOnce() {
  if (active_) set(kInputEmergencyStop1, true);
}

void OperatorKeys::reset() {
  if (!active_) return;
  set(kInputEmergencyStop1, false);
  set(kInputReset, true);
  resetPress_.start();
}

bool OperatorKeys::isForTheArm(const QEvent& event) const {
  const QEvent::Type type = event.type();
  if (!active_ || QApplication::activeModalWidget() != nullptr) return false;
  if (type != QEvent::KeyPress && type != QEvent::KeyRelease && type != QEvent::ShortcutOverride) return false;
  const int key = static_cast<const QKeyEvent&>(event).key();
  return window_.isActiveWindow() && (key == Qt::Key_Space || key == Qt::Key_Escape);
}

bool OperatorKeys::eventFilter(QObject* watched, QEvent* event) {
  if (active_ && watched == &window_ && event->type() == QEvent::WindowDeactivate) set(kInputDeadMan, false);
  if (!isForTheArm(*event)) return QObject::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();  // the key is no shortcut now: it comes as a press
  } else if (!key.isAutoRepeat()) {
    const bool down = event->type() == QEvent::KeyPress;
    if (key.key() == Qt::Key_Space) set(kInputDeadMan, down);
    if (key.key() == Qt::Key_Escape && down) stopAtOnce();
  }
  return true;
}

void OperatorKeys::set(std::uint16_t input, bool down) {
  const auto inputs = static_cast<std::uint16_t>(down ? inputs_ | input : inputs_ & ~input);
  if (inputs == inputs_) return;
  inputs_ = inputs;
  emit pressed(inputs_);
}

}  // namespace haptiv

#include "moc_OperatorKeys.cpp"
