#include "app/editor/panels/NumberField.h"

#include <QKeyEvent>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace haptiv {

namespace {

/// As many as four digits of the value take.
int decimalsOf(double value, int least) {
  constexpr int kMost = 12;
  if (value == 0 || !std::isfinite(value)) return least;
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(std::abs(value)))), least, kMost);
}

}  // namespace

NumberField::NumberField(const Format& format, QWidget* parent) : QDoubleSpinBox(parent), format_(format) {
  setDecimals(format.decimals);
  setRange(format.minimum, format.maximum);
  setSingleStep(format.step);
  setSuffix(format.suffix);
  setKeyboardTracking(false);
  setAccelerated(true);
  setFocusPolicy(Qt::StrongFocus);
  setAlignment(Qt::AlignRight);
  setMinimumWidth(110);
}

void NumberField::show(double value) {
  const QSignalBlocker quiet(this);
  setDecimals(decimalsOf(value, format_.decimals));
  setRange(std::min(format_.minimum, value), std::max(format_.maximum, value));
  setValue(value);
}

QString NumberField::textFromValue(double value) const {
  QLocale plain = locale();
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  QString text = plain.toString(value, 'f', decimals());
  const QString point = plain.decimalPoint();
  if (!text.contains(point)) return text;
  while (text.endsWith('0')) text.chop(1);
  if (text.endsWith(point)) text.chop(point.size());
  return text == "-0" ? "0" : text;
}

bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();  // these undo edits of the scene, not of the text in the field
      return false;
    }
  }
  return QDoubleSpinBox::event(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) return QDoubleSpinBox::wheelEvent(event);
  event->ignore();  // the panel is being scrolled
}

}  // namespace haptiv

#include "moc_NumberField.cpp"
