#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "scenegraph/writing/SceneSaver.h"
#include "scenegraph/writing/SceneWriter.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;
using testing::contentsOf;
using ::testing::HasSubstr;
using testing::put;
using testing::read;
using testing::ScratchFolder;
using testing::textOf;

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(SceneWriter, KeepsNamesSharingAndValues) {
  const std::string text = writeSceneText(
      read("DEF s HapticSurface { stiffness 512.5 label \"a \\\"b\\\"\" } DEF c Cube { } Separator { USE c }")
          .root.get());
  EXPECT_THAT(text, HasSubstr("DEF s HapticSurface"));
  EXPECT_THAT(text, HasSubstr("stiffness 512.5"));
  EXPECT_THAT(text, HasSubstr("USE c"));
  const SceneFile again = readSceneText(text, "again.iv");
  ASSERT_TRUE(again.root) << textOf(again.diagnostics);
  EXPECT_EQ(writeSceneText(again.root.get()), text);
}

TEST(SceneWriter, RefusesNumbersThatCannotBeReadBack) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const SceneFile scene = read("DEF here Translation { }");
    static_cast<SoTranslation*>(scene.root->getChild(0))->translation.setValue(0, bad, 0);
    EXPECT_THAT(messageOf([&] { writeSceneText(scene.root.get()); }), HasSubstr("Translation \"here\": translation"));
  }
}

TEST(SceneWriter, WritesNodesThatAreConnectedToThemselvesSoThatTheyCanBeRead) {
  const SceneFile scene = read("Blinker { Cube { } } Pendulum { } Shuttle { } Rotor { } Cone { }");
  const SceneFile again = readSceneText(writeSceneText(scene.root.get()), "again");
  ASSERT_TRUE(again.root) << textOf(again.diagnostics);
  ASSERT_EQ(again.root->getNumChildren(), 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(again.root->getChild(i)->getTypeId(), scene.root->getChild(i)->getTypeId());
}

TEST(SceneWriter, KeepsTheDraggersAndManipulatorsOfAFile) {
  const SceneFile scene =
      read("HandleBoxManip { translation 1 2 3 } Cube { } TrackballDragger { } Translate1Dragger { }");
  const SceneFile again = readSceneText(writeSceneText(scene.root.get()), "again");
  ASSERT_TRUE(again.root) << textOf(again.diagnostics);
  ASSERT_EQ(again.root->getNumChildren(), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(again.root->getChild(i)->getTypeId(), scene.root->getChild(i)->getTypeId());
  EXPECT_EQ(static_cast<SoTransform*>(again.root->getChild(0))->translation.getValue(), SbVec3f(1, 2, 3));
}

TEST(SceneSaver, ReplacesAFileAndKeepsItsPermissionsAndLinks) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "scene.iv";
  put(file, "before");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("scene.iv", folder.path() / "link.iv");
  saveScene(read("Cube { }").root.get(), folder.path() / "link.iv");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.iv"));
  EXPECT_THAT(contentsOf(file), HasSubstr("Cube"));
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);  // nothing is left beside them
}

constexpr const char* kPrototypes = R"(#VRML V2.0 utf8
PROTO Box2 [ field SFVec3f size 1 1 1 ] { Shape { geometry Box { size IS size } } }
PROTO Two [ field SFVec3f far 3 0 0 ] {
  Group { children [ Box2 { size 0.1 0.2 0.3 } Transform { translation IS far children Box2 { } } ] }
}
HapticTool { home 0.35 0 0 }
HapticSurface { label "felt" }
Two { far 0 4 0 }
)";

TEST(SceneSaver, WritesOutWhatPrototypesMake) {
  const testing::ScratchFolder folder;
  const SceneFile scene = readSceneText(kPrototypes, "prototypes.wrl");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  for (int time = 0; time < 2; ++time) {  // and what is saved can be saved again
    saveScene(scene.root.get(), folder.path() / "saved.iv");
    const SceneFile saved = readScene(folder.path() / "saved.iv");
    ASSERT_TRUE(saved.root) << textOf(saved.diagnostics);
    EXPECT_FALSE(findPrototype(saved.root.get()));
    const CompiledScene before = SceneCompiler().compile(scene.root.get());
    const CompiledScene after = SceneCompiler().compile(saved.root.get());
    ASSERT_TRUE(before.scene && after.scene);
    ASSERT_EQ(after.scene->walls.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(after.scene->walls[i].shape.centre, before.scene->walls[i].shape.centre);
      EXPECT_EQ(after.scene->walls[i].shape.axes, before.scene->walls[i].shape.axes);
    }
  }
  EXPECT_TRUE(findPrototype(scene.root.get())) << "the scene that is open keeps them";
}

TEST(SceneSaver, LeavesTheFileAsItWasWhenItCannotBeWritten) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "scene.iv";
  put(file, "before");
  const SceneFile scene = read("DEF here Translation { }");
  static_cast<SoTranslation*>(scene.root->getChild(0))->translation.setValue(std::nanf(""), 0, 0);
  EXPECT_THAT(messageOf([&] { saveScene(scene.root.get(), file); }), HasSubstr("not finite"));
  EXPECT_EQ(contentsOf(file), "before");
  const SceneFile good = read("Cube { }");
  EXPECT_THAT(messageOf([&] { saveScene(good.root.get(), folder.path() / "none/scene.iv"); }),
              HasSubstr("No such file"));
  EXPECT_THAT(messageOf([&] { saveScene(good.root.get(), folder.path()); }), HasSubstr("not a regular file"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace haptiv
