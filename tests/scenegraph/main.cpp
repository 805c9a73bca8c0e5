#include <gtest/gtest.h>

#include "scenegraph/SceneFile.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  haptiv::initSceneGraph();
  return RUN_ALL_TESTS();
}
