#include "app/view/picture/OffscreenPicture.h"

#include <gtest/gtest.h>

#include <QColor>
#include <cstdlib>

#include "scenegraph/GraphWalk.h"

namespace haptiv {
namespace {

constexpr const char* kRedWall = R"(#Inventor V2.1 ascii
Separator { Material { diffuseColor 0.8 0.1 0.1 } Cube { width 0.2 height 0.2 depth 0.2 } }
)";

NodeRef<SoSeparator> redWall() {
  SceneFile file = readSceneText(kRedWall, "red wall");
  EXPECT_TRUE(file.root);
  return file.root;
}

TEST(OffscreenPicture, ShowsTheWallsColourInTheMiddleAndTheBackgroundAtTheCorners) {
  const QImage picture = drawOffscreen(redWall().get(), 320, 200);
  ASSERT_EQ(picture.size(), QSize(320, 200));
  const QColor middle = picture.pixelColor(160, 100);
  EXPECT_GT(middle.red(), 3 * middle.green());
  EXPECT_GT(middle.red(), 90);
  for (const QPoint corner : {QPoint(0, 0), QPoint(319, 0), QPoint(0, 199), QPoint(319, 199)}) {
    const QColor calm = picture.pixelColor(corner);
    EXPECT_GT(std::min({calm.red(), calm.green(), calm.blue()}), 180);
  }
}

TEST(OffscreenPicture, DoesNotLookThroughTheScenesOwnCameras) {
  const QImage without = drawOffscreen(redWall().get(), 64, 64);
  for (const char* camera : {"PerspectiveCamera { position 90 90 90 }", "OrthographicCamera { height 0.01 }",
                             "VRMLViewpoint { position 90 90 90 }"}) {
    std::string text = kRedWall;
    text.insert(text.find("Separator {") + 11, std::string(" ") + camera + " ");
    const SceneFile file = readSceneText(text, "with a camera");
    ASSERT_TRUE(file.root);
    EXPECT_EQ(drawOffscreen(file.root.get(), 64, 64), without) << camera;
  }
}

/// What is seen is what is felt, from afar too.
TEST(OffscreenPicture, ShowsTheFinestOfLevels) {
  const QImage fine = drawOffscreen(redWall().get(), 64, 64);
  for (const std::string levels :
       {"LOD { range [ 0.0001 ]", "LevelOfDetail { screenArea [ 1e9 ]", "VRMLLOD { range [ 0.0001 ] level ["}) {
    std::string text = kRedWall;
    text.insert(text.find("Cube"), levels + " ");
    text.insert(text.rfind('}'), (levels.ends_with('[') ? " Sphere { radius 0.05 } ] }" : " Sphere { radius 0.05 } }"));
    const SceneFile file = readSceneText(text, "with levels");
    ASSERT_TRUE(file.root) << text;
    EXPECT_EQ(drawOffscreen(file.root.get(), 64, 64), fine) << levels;
    EXPECT_EQ(drawnTriangles(file.root.get()), 12u) << levels;
  }
}

TEST(OffscreenPicture, NeedsNoDisplay) {
  ASSERT_EQ(std::getenv("DISPLAY"), nullptr);
  EXPECT_FALSE(drawOffscreen(redWall().get(), 64, 64).isNull());
}

TEST(OffscreenPicture, SeesAllOfTheSceneWhateverItsShape) {
  for (const QSize size : {QSize(400, 100), QSize(100, 400)}) {
    const QImage picture = drawOffscreen(redWall().get(), size.width(), size.height());
    int red = 0;
    for (int y = 0; y < size.height(); ++y) {
      for (int x = 0; x < size.width(); ++x) {
        const QColor c = picture.pixelColor(x, y);
        if (c.red() <= 2 * c.green()) continue;
        ++red;
        EXPECT_TRUE(x > 0 && y > 0 && x < size.width() - 1 && y < size.height() - 1) << "cut off at " << x << ", " << y;
      }
    }
    EXPECT_GT(red, 1000);
  }
}

TEST(OffscreenPicture, IsTheSameAgain) {
  const NodeRef<SoSeparator> wall = redWall();
  EXPECT_EQ(drawOffscreen(wall.get(), 200, 120), drawOffscreen(wall.get(), 200, 120));
}

TEST(OffscreenPicture, SaysWhatToDoWhereThePictureIsTooLarge) {
  try {
    drawOffscreen(redWall().get(), 32000, 32000);
    FAIL() << "drew 32000 x 32000 pixels";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("smaller"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace haptiv
