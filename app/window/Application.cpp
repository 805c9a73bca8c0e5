#include "app/window/Application.h"

#include <Inventor/Qt/SoQt.h>

#include <QApplication>
#include <QStyleFactory>

#include "app/view/QtEnvironment.h"
#include "app/window/MainWindow.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {

int runApplication(int argc, char** argv, const QString& sceneOrLog) {
  prepareQtEnvironment();
  QApplication application(argc, argv);
  QApplication::setApplicationName("Haptiv");
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QWidget soQtHost;  // SoQt wants a widget that lives as long as it does
  SoQt::init(&soQtHost);
  initSceneGraph();

  MainWindow window;
  window.show();
  if (!sceneOrLog.isEmpty()) window.open(sceneOrLog);
  return QApplication::exec();
}

}  // namespace haptiv
