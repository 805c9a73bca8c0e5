#include <Inventor/Qt/SoQt.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QMainWindow>

#include "app/view/QtEnvironment.h"
#include "scenegraph/reading/SceneFile.h"

/// Runs the tests within an application, as main does it. Listing the tests needs no display.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  haptiv::prepareQtEnvironment();
  const QApplication application(argc, argv);
  QMainWindow window;
  SoQt::init(&window);
  haptiv::initSceneGraph();
  return RUN_ALL_TESTS();
}
