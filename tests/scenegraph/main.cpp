#include <gtest/gtest.h>

#include "scenegraph/reading/SceneFile.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  haptiv::initSceneGraph();
  return RUN_ALL_TESTS();
}
