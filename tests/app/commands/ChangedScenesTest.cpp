#include "app/commands/session/ChangedScenes.h"

#include <gmock/gmock.h>

#include "app/commands/ExitCode.h"
#include "scenegraph/compiling/SceneCompiler.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

/// A log may hold a text that names files, where they could not be written out.
TEST(ChangedScenes, AreRefusedWhereWhatTheyIncludeIsNotThere) {
  initSceneGraph();
  const TestFolder folder;
  folder.write("wall.iv", "#Inventor V2.1 ascii\nHapticSurface { label \"wall\" } Cube { }");
  const std::string text = "#Inventor V2.1 ascii\nHapticTool { home 9 9 9 }\nFile { name \"wall.iv\" }\n";
  const SceneFile read = readScene(folder.write("scene.iv", text));
  const CompiledScene compiled = SceneCompiler().compile(read);
  ASSERT_TRUE(compiled.scene);
  ASSERT_EQ(compiled.scene->walls.size(), 1u);
  try {
    withChanges({{*compiled.scene, text}}, {{"wall", "stiffness", "500"}});
    FAIL() << "the wall would be gone";
  } catch (const CommandFailure& failure) {
    EXPECT_THAT(failure.what(), ::testing::HasSubstr("run haptiv in the folder of the scene"));
  }
}

}  // namespace
}  // namespace haptiv
