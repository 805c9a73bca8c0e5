#pragma once

#include <QMainWindow>

namespace haptiv {

/// The application's window: the view in the middle, the editor's panels beside it, plots or the replay below.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;
};

}  // namespace haptiv
