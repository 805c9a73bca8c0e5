#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFFloat.h>
#include <gtest/gtest.h>

#include <random>

#include "app/editor/edits/Edits.h"
#include "app/editor/handles/Handles.h"
#include "tests/app/editor/EditedScene.h"

namespace haptiv {
namespace {

/// Edits as a user's, chosen by a seed.
class RandomUser {
 public:
  RandomUser(EditedScene& scene, unsigned seed) : scene_(scene), random_(seed) {}

  void doSomething() {
    const std::vector<SceneItem> items = scene_.items();
    ASSERT_TRUE(scene_.select(items[pick(items.size())].name));
    SceneDocument& document = scene_.document;
    switch (pick(8)) {
      case 0:
        return addShape(document, static_cast<SceneItem::Kind>(pick(3)));
      case 1:
        return removeShape(document);
      case 2:
        return moveShape(
            document,
            [&](ShapeFrame& frame) {
              frame.setCentre({real(), real(), 0});
            },
            "move", gesture());
      case 3:
        return moveShape(
            document,
            [&](ShapeFrame& frame) {
              frame.setSize({0.1 + real(), 0.2, 0.05});
            },
            "resizing");
      case 4:
        return moveShape(
            document, [&](ShapeFrame& frame) { frame.setYaw(3 * real()); }, "turn", gesture());
      case 5:
        return setField("damping", static_cast<float>(10 + 10 * real()));
      case 6:
        return setField("enabled", SbBool(pick(2)));
      default:
        return undoOrRedo();
    }
  }

 private:
  std::size_t pick(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  double real() { return std::uniform_real_distribution<>(-0.09, 0.09)(random_); }
  Gesture gesture() { return static_cast<Gesture>(pick(2)); }

  template <typename Value>
  void setField(const char* name, Value value) {
    using Field = std::conditional_t<std::is_same_v<Value, float>, SoSFFloat, SoSFBool>;
    const std::vector<SceneItem> items = scene_.items();
    const SceneItem* item = findItem(items, scene_.document.selection());
    if (!item || !item->property || !item->property->getField(name)) return;
    editProperty(
        scene_.document, name, [&](const SoField& field) { return FieldValue::of<Field>(field, value); },
        pick(2) ? Reach::onlyThis : Reach::allThatShare, gesture());
  }

  void undoOrRedo() { pick(3) ? scene_.document.undoStack().undo() : scene_.document.undoStack().redo(); }

  EditedScene& scene_;
  std::mt19937 random_;
};

class RandomEdits : public testing::TestWithParam<unsigned> {};

TEST_P(RandomEdits, AreUndoneAndRedoneToTheLastLetter) {
  for (const char* text : {kTwoWalls, kSharedProperty}) {
    EditedScene scene(text);
    Handles handles(scene.document);
    const std::string original = scene.document.text();
    RandomUser user(scene, GetParam());
    for (int i = 0; i < 120; ++i) user.doSomething();
    letEventsRun();
    const std::string edited = scene.document.text();
    QUndoStack& stack = scene.document.undoStack();
    const int steps = stack.index();
    EXPECT_GT(steps, 20);
    for (int round = 0; round < 2; ++round) {
      for (int i = 0; i < steps; ++i) {
        stack.undo();
        if (i % 7 == 0) letEventsRun();
      }
      ASSERT_EQ(scene.document.text(), original);
      for (int i = 0; i < steps; ++i) stack.redo();
      ASSERT_EQ(scene.document.text(), edited);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEdits, testing::Values(1u, 2u, 3u, 4u));

TEST(Undo, MergesTheStepsOfOneGestureOnly) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("left"));
  const std::string original = scene.document.text();
  const auto set = [&](float value, Gesture gesture) {
    editProperty(
        scene.document, "stiffness", [&](const SoField& field) { return FieldValue::of<SoSFFloat>(field, value); },
        Reach::onlyThis, gesture);
  };
  for (int i = 0; i < 10; ++i) set(100.0f * static_cast<float>(i + 1), 1);
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  set(300, 2);
  EXPECT_EQ(scene.document.undoStack().count(), 2);
  scene.document.undoStack().undo();
  scene.document.undoStack().undo();
  EXPECT_EQ(scene.document.text(), original);
}

TEST(Undo, ForgetsAGestureThatEndsWhereItBegan) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("left"));
  for (const double y : {0.1, 0.2, 0.0}) {
    moveShape(
        scene.document,
        [y](ShapeFrame& frame) {
          frame.setCentre({-0.1, y, 0});
        },
        "move", 1);
  }
  EXPECT_EQ(scene.document.undoStack().count(), 0);
  EXPECT_FALSE(scene.document.isModified());
}

}  // namespace
}  // namespace haptiv
