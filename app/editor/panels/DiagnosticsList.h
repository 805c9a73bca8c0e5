#pragma once

#include <QListWidget>

#include "app/editor/document/SceneDocument.h"

namespace haptiv {

/// What is wrong with the scene. A click selects the shape that is meant, where there is one. Thread: GUI.
class DiagnosticsList : public QListWidget {
  Q_OBJECT
 public:
  explicit DiagnosticsList(SceneDocument& document, QWidget* parent = nullptr);

 private:
  void refresh();
  void selectSource(int row);

  SceneDocument& document_;
};

}  // namespace haptiv
