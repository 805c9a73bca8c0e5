#include <gtest/gtest.h>

#include <QApplication>

/// Widgets need an application, and that a display; a mere list of the tests does not.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
