#include <Inventor/Qt/SoQt.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QWidget>

#include "app/view/QtEnvironment.h"
#include "scenegraph/reading/SceneFile.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();  // ctest asks while building: there is no display
  haptiv::prepareQtEnvironment();
  QApplication application(argc, argv);
  QWidget top;
  SoQt::init(&top);
  haptiv::initSceneGraph();
  return RUN_ALL_TESTS();
}
