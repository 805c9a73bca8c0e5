#pragma once

#include <QLabel>

#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// Says in a word whether a log is whole, cut off, or unreadable in part; the tool tip says more.
class LogStateLabel : public QLabel {
  Q_OBJECT
 public:
  explicit LogStateLabel(QWidget* parent = nullptr);

 public slots:
  /// Null: there is no log.
  void showLog(const haptiv::SessionLog* log);
  /// A part of the log could not be read.
  void showFailure(const QString& message);

 private:
  void say(const QString& text, const QString& hint, const QString& colour);
};

}  // namespace haptiv
