#include <gmock/gmock.h>

#include <QFile>
#include <QSignalSpy>

#include "app/editor/commands/SetField.h"
#include "app/editor/edits/Edits.h"
#include "tests/app/editor/EditedScene.h"

#include <Inventor/fields/SoSFFloat.h>

namespace haptiv {
namespace {

TEST(SceneDocument, StartsWithASceneThatASessionCanRun) {
  SceneDocument document;
  ASSERT_TRUE(document.compiled().scene);
  EXPECT_FALSE(hasErrors(document.diagnostics()));
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.path(), "");
}

TEST(SceneDocument, KeepsTheOldSceneWhenAFileCannotBeRead) {
  EditedScene scene(kTwoWalls);
  SoSeparator* root = scene.document.root();
  QSignalSpy told(&scene.document, &SceneDocument::diagnosticsChanged);
  QFile bad(scene.pathOf("bad.iv"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("#Inventor V2.1 ascii\nSeparator { Cube { widht 1 } }\n");
  bad.close();
  EXPECT_FALSE(scene.document.open(scene.pathOf("bad.iv")));
  EXPECT_EQ(scene.document.root(), root);
  EXPECT_TRUE(hasErrors(scene.document.diagnostics()));
  EXPECT_EQ(told.count(), 1);
  EXPECT_EQ(scene.document.compiled().scene->walls.size(), 2u);
  EXPECT_EQ(scene.document.path(), scene.pathOf("scene.iv"));
}

TEST(SceneDocument, JudgesOnTheDeviceDescriptionBesideTheScene) {
  EditedScene scene(kTwoWalls);
  const auto write = [&](const QString& name, const QByteArray& text) {
    QFile file(scene.pathOf(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  };
  QByteArray strong = QByteArray::fromStdString(loadDeviceDescription("vishard10").text);
  strong.replace("peakForce = 170", "peakForce = 171");
  write("strong.toml", strong);
  write("beside.iv",
        "#Inventor V2.1 ascii\nHapticDevice { description \"strong.toml\" }\nHapticTool { home 0.3 0 0 }\n");
  ASSERT_TRUE(scene.document.open(scene.pathOf("beside.iv")));
  EXPECT_FALSE(hasErrors(scene.document.diagnostics()));
  EXPECT_EQ(scene.document.device().hand.peakForce, 171);
}

TEST(SceneDocument, JudgesAtTheRateOfTheSession) {
  EditedScene scene(
      "#Inventor V2.1 ascii\nHapticTool { home 0.3 0 0 }\nTranslation { translation 0.3 0.2 0 }\n"
      "HapticSurface { stiffness 9e6 }\nCube { width 0.1 height 0.1 depth 0.1 }\n");
  const auto told = [&] { return scene.document.diagnostics().at(0).message; };
  EXPECT_THAT(told(), testing::HasSubstr("cannot be rendered stably at 1000 Hz"));
  scene.document.judgeAt(4000);
  letEventsRun();
  EXPECT_THAT(told(), testing::HasSubstr("too stiff for the arm")) << "the sampled bound is sixteen times as high";
}

TEST(SceneDocument, ListsErrorsFirstAndEachByItsLine) {
  EditedScene scene(
      "#Inventor V2.1 ascii\nHapticTool { home 0.3 0 0 }\nTranslation { translation 0.3 0.2 0 }\n"
      "HapticSurface { stiffness 2000 label \"a\" } Cube { width 0.1 height 0.001 depth 0.1 }\n"
      "HapticSurface { stiffness 9e6 label \"b\" } Cube { width 0.1 height 0.1 depth 0.1 }\n"
      "HapticSurface { label \"a\" }\n");
  std::vector<int> lines;
  for (const Diagnostic& each : scene.document.diagnostics()) lines.push_back(each.line);
  EXPECT_EQ(lines, (std::vector<int>{4, 5, 6}));
}

/// So it is felt within a frame: SessionControl publishes at the signal, and the servo takes the scene in its next
/// tick.
TEST(SceneDocument, CompilesAnEditInTheSameTurnOfTheEventLoop) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("left"));
  QSignalSpy compiled(&scene.document, &SceneDocument::sceneCompiled);
  editProperty(scene.document, "stiffness", number(4321), Reach::onlyThis);
  QCoreApplication::processEvents();
  EXPECT_EQ(compiled.count(), 1);
  EXPECT_EQ(scene.document.compiled().scene->walls[0].surface.stiffness, 4321);
}

/// Who feels the scene does not wait for the rules, nor for panels and pictures.
TEST(SceneDocument, HasAnEditFeltBeforeItIsJudgedAndShown) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("left"));
  const auto said = [&] {
    std::vector<std::string> messages;
    for (const Diagnostic& each : scene.document.diagnostics()) messages.push_back(each.message);
    return messages;
  };
  const std::vector<std::string> known = said();
  std::vector<std::string> order;
  double felt = 0;
  QObject::connect(&scene.document, &SceneDocument::sceneReady, [&] {
    order.emplace_back("ready");
    felt = scene.document.compiled().scene->walls[0].surface.stiffness;
    EXPECT_EQ(said(), known);
  });
  QObject::connect(&scene.document, &SceneDocument::sceneChanged, [&] {
    order.emplace_back("changed");
    EXPECT_NE(said(), known) << "1e9 N/m cannot be rendered";
  });
  editProperty(scene.document, "stiffness", number(1e9F), Reach::onlyThis);
  letEventsRun();
  EXPECT_EQ(felt, 1e9F);
  EXPECT_EQ(order, (std::vector<std::string>{"ready", "changed"}));
}

TEST(SceneDocument, KeepsTheLastValidSceneWhileAnEditIsInvalid) {
  EditedScene scene(kTwoWalls);
  const auto valid = scene.document.compiled().scene;
  ASSERT_TRUE(scene.select("left"));
  editProperty(scene.document, "stiffness", number(-5), Reach::onlyThis);
  letEventsRun();
  EXPECT_EQ(scene.document.compiled().scene, valid);
  EXPECT_TRUE(hasErrors(scene.document.diagnostics()));
  scene.document.undoStack().undo();
  letEventsRun();
  EXPECT_FALSE(hasErrors(scene.document.diagnostics()));
  EXPECT_NE(scene.document.compiled().scene, valid);
}

TEST(SceneDocument, CompilesAThousandEditsOfOneTurnOnce) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("left"));
  QSignalSpy changed(&scene.document, &SceneDocument::sceneChanged);
  QSignalSpy compiled(&scene.document, &SceneDocument::sceneCompiled);
  const std::uint32_t version = scene.document.compiled().scene->version;
  for (int i = 0; i < 1000; ++i) {
    editProperty(scene.document, "stiffness", number(1000.0f + static_cast<float>(i)), Reach::onlyThis);
  }
  EXPECT_EQ(changed.count(), 0);
  letEventsRun();
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(compiled.count(), 1);
  EXPECT_EQ(scene.document.compiled().scene->version, version + 1);
  EXPECT_EQ(scene.document.compiled().scene->walls[0].surface.stiffness, 1999);
}

TEST(SceneDocument, LeaksNoNodeOverAThousandEdits) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("left"));
  const NodeRef<SoNode> shape(scene.document.selection()->getTail());
  const NodeRef<SoNode> unit(scene.document.selection()->getNodeFromTail(1));
  scene.document.select(nullptr);
  letEventsRun();
  const int shapeReferences = shape.get()->getRefCount();
  const int unitReferences = unit.get()->getRefCount();
  for (int i = 0; i < 250; ++i) {
    ASSERT_TRUE(scene.select("left"));
    moveShape(
        scene.document,
        [&](ShapeFrame& frame) {
          frame.setCentre({0.2, 0.01 * i, 0});
        },
        "move");
    editProperty(scene.document, "stiffness", number(500.0f + static_cast<float>(i)), Reach::onlyThis);
    removeShape(scene.document);
    scene.document.undoStack().undo();
    addShape(scene.document, SceneItem::Kind::wall);
    scene.document.undoStack().undo();
  }
  scene.document.select(nullptr);
  scene.document.undoStack().clear();
  letEventsRun();
  EXPECT_EQ(shape.get()->getRefCount(), shapeReferences);
  EXPECT_EQ(unit.get()->getRefCount(), unitReferences);
  scene.document.createNew();
  letEventsRun();
  EXPECT_EQ(unit.get()->getRefCount(), 1) << "only this test holds it";
}

TEST(SceneDocument, GivesTheSameCompiledSceneAfterSavingAndReopening) {
  EditedScene scene(kTwoWalls);
  for (const auto kind : {SceneItem::Kind::wall, SceneItem::Kind::dampingZone, SceneItem::Kind::springZone}) {
    addShape(scene.document, kind);
    letEventsRun();
  }
  const auto before = scene.document.compiled().scene;
  ASSERT_EQ(before->walls.size(), 3u);
  ASSERT_EQ(before->zones.size(), 2u);
  EXPECT_TRUE(scene.document.isModified());
  QSignalSpy modified(&scene.document, &SceneDocument::modifiedChanged);
  const std::string text = scene.document.text();
  scene.document.save(scene.pathOf("saved.iv"));
  EXPECT_FALSE(scene.document.isModified());
  EXPECT_EQ(modified.count(), 1);
  EXPECT_EQ(scene.document.path(), scene.pathOf("saved.iv"));

  SceneDocument reopened;
  ASSERT_TRUE(reopened.open(scene.pathOf("saved.iv")));
  EXPECT_EQ(reopened.text(), text);
  const auto after = reopened.compiled().scene;
  ASSERT_EQ(after->walls.size(), before->walls.size());
  ASSERT_EQ(after->zones.size(), before->zones.size());
  for (std::size_t i = 0; i < before->walls.size(); ++i) {
    EXPECT_EQ(after->walls[i].shape.centre, before->walls[i].shape.centre);
    EXPECT_EQ(after->walls[i].shape.axes, before->walls[i].shape.axes);
    EXPECT_EQ(after->walls[i].surface.stiffness, before->walls[i].surface.stiffness);
  }
  for (std::size_t i = 0; i < before->zones.size(); ++i) {
    EXPECT_EQ(after->zones[i].kind, before->zones[i].kind);
    EXPECT_EQ(after->zones[i].shape.centre, before->zones[i].shape.centre);
    EXPECT_EQ(after->zones[i].anchor, before->zones[i].anchor);
  }
}

TEST(SceneDocument, SaysWhyAFileCannotBeWritten) {
  EditedScene scene(kTwoWalls);
  addShape(scene.document, SceneItem::Kind::wall);
  EXPECT_THROW(scene.document.save(scene.pathOf("no-such-folder/scene.iv")), std::runtime_error);
  EXPECT_TRUE(scene.document.isModified());
  EXPECT_EQ(scene.document.path(), scene.pathOf("scene.iv"));
}

TEST(SceneDocument, ForgetsTheSelectionThatIsNoLongerInTheScene) {
  EditedScene scene(kTwoWalls);
  addShape(scene.document, SceneItem::Kind::wall);
  letEventsRun();
  ASSERT_TRUE(scene.document.selection());
  QSignalSpy told(&scene.document, &SceneDocument::selectionChanged);
  scene.document.undoStack().undo();
  letEventsRun();
  EXPECT_EQ(scene.document.selection(), nullptr);
  EXPECT_EQ(told.count(), 1);
}

TEST(SetField, RefusesTextThatIsNoValueOfTheField) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("left"));
  SoNode* cube = scene.document.selection()->getTail();
  EXPECT_THROW(FieldValue(*cube->getField("width"), "broad"), std::invalid_argument);
  scene.document.undoStack().push(new SetField(scene.document, cube, cube->getField("width"),
                                               FieldValue(*cube->getField("width"), "0.5"), "width"));
  EXPECT_EQ(static_cast<SoSFFloat*>(cube->getField("width"))->getValue(), 0.5f);
}

}  // namespace
}  // namespace haptiv
