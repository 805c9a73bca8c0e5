#pragma once

#include <QString>
#include <QVector>

#include "app/editor/panels/NumberField.h"

namespace haptiv {

/// How one field of a node is shown in the property panel.
struct FieldRow {
  enum class Kind { number, vector, yaw, toggle, text };
  Kind kind = Kind::number;
  const char* field = "";
  QString title;
  QString tip;
  NumberField::Format format;
  double shownPerUnit = 1;  ///< shown value = value in SI * this
};

/// The rows for a node of this keyword; none: it is not edited in the panel.
QVector<FieldRow> rowsFor(const QString& keyword);

}  // namespace haptiv
