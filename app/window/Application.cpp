#include "app/window/Application.h"

#include <QApplication>
#include <QStyleFactory>

#include "app/view/QtEnvironment.h"
#include "app/window/MainWindow.h"

namespace haptiv {

int runApplication(int argc, char** argv, const QString& sceneOrLog) {
  prepareQtEnvironment();
  QApplication application(argc, argv);
  QApplication::setApplicationName("Haptiv");
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  MainWindow window;
  window.show();
  if (!sceneOrLog.isEmpty()) window.open(sceneOrLog);
  return QApplication::exec();
}

}  // namespace haptiv
