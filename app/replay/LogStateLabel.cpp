#include "app/replay/LogStateLabel.h"

namespace haptiv {

namespace {

constexpr const char* kQuiet = "#868e96";
constexpr const char* kGood = "#2e7d4f";
constexpr const char* kWarning = "#b35c00";
constexpr const char* kBad = "#b02a2a";

}  // namespace

LogStateLabel::LogStateLabel(QWidget* parent) : QLabel(parent) {
  showLog(nullptr);
}

void LogStateLabel::showLog(const SessionLog* log) {
  if (!log) return say(tr("no log"), {}, kQuiet);
  const QString lost = log->dropped() > 0 ? tr(", %1 ticks lost").arg(log->dropped()) : QString();
  const QString none = log->tickCount() == 0 ? tr(", no ticks") : QString();
  if (!log->complete()) {
    return say(
        tr("cut off") + lost + none,
        tr("The session did not end in order: a crash, a power cut or a full disk. All that reached the disk is here."),
        kWarning);
  }
  if (log->dropped() > 0) {
    return say(tr("complete") + lost + none, tr("The disk was too slow for the lost ticks; the others are all here."),
               kWarning);
  }
  say(tr("complete") + none, tr("The log was closed in order and holds every tick."), kGood);
}

void LogStateLabel::showFailure(const QString& message) {
  say(tr("unreadable in part"), message, kBad);
}

void LogStateLabel::say(const QString& text, const QString& hint, const QString& colour) {
  setText(text);
  setToolTip(hint);
  setStyleSheet("color: " + colour);
}

}  // namespace haptiv

#include "moc_LogStateLabel.cpp"
