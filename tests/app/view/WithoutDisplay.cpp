#include <gtest/gtest.h>

#include <cstdlib>

#include "scenegraph/reading/SceneFile.h"

/// Runs the tests as on a machine without any display.
int main(int argc, char** argv) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  testing::InitGoogleTest(&argc, argv);
  haptiv::initSceneGraph();
  return RUN_ALL_TESTS();
}
