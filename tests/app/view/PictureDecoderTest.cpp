#include "app/view/picture/PictureDecoder.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QDir>
#include <QImage>
#include <QTemporaryDir>

#include "app/view/picture/OffscreenPicture.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {
namespace {

/// Red above, blue below.
QImage twoColours(int size, QImage::Format format) {
  QImage image(size, size, format);
  image.fill(QColor(250, 5, 5));
  for (int y = size / 2; y < size; ++y) {
    for (int x = 0; x < size; ++x) image.setPixelColor(x, y, QColor(5, 5, 250, 128));
  }
  return image;
}

std::string saved(const QImage& image, const char* format) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  EXPECT_TRUE(image.save(&buffer, format));
  return buffer.data().toStdString();
}

TEST(PictureDecoder, GivesRowsFromBelow) {
  const DecodePicture decode = pictureDecoder();
  for (const char* format : {"png", "bmp", "jpeg"}) {
    const Picture picture = decode(saved(twoColours(16, QImage::Format_RGB32), format));
    ASSERT_EQ(picture.width, 16) << format;
    ASSERT_EQ(picture.height, 16);
    ASSERT_EQ(picture.components, 3);
    ASSERT_EQ(picture.pixels.size(), 16u * 16 * 3);
    const auto part = [&](std::size_t at) { return static_cast<unsigned char>(picture.pixels[at]); };
    EXPECT_LT(part(0), 60) << format;
    EXPECT_GT(part(2), 200) << format;
    EXPECT_GT(part(picture.pixels.size() - 3), 200) << format;
  }
}

TEST(PictureDecoder, KeepsOpacityAndSamplesLargePicturesDown) {
  const DecodePicture decode = pictureDecoder();
  const Picture clear = decode(saved(twoColours(8, QImage::Format_ARGB32), "png"));
  ASSERT_EQ(clear.components, 4);
  EXPECT_EQ(static_cast<unsigned char>(clear.pixels[3]), 128);
  const Picture large = decode(saved(QImage(5000, 30, QImage::Format_RGB32), "png"));
  EXPECT_EQ(large.width, 1666);
  EXPECT_EQ(large.height, 10);
}

TEST(PictureDecoder, SaysWhatIsWrong) {
  const DecodePicture decode = pictureDecoder();
  const std::string png = saved(twoColours(64, QImage::Format_RGB32), "png");
  EXPECT_THROW(decode(""), std::runtime_error);
  EXPECT_THROW(decode("no picture"), std::runtime_error);
  EXPECT_THROW(decode(png.substr(0, 60)), std::runtime_error);
  EXPECT_THROW(decode(saved(QImage(9000, 2, QImage::Format_RGB32), "png")), std::runtime_error);
  EXPECT_THROW(decode("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"></svg>"), std::runtime_error);
}

TEST(PictureDecoder, LetsTexturesBeSeen) {
  const QTemporaryDir folder;
  ASSERT_TRUE(twoColours(16, QImage::Format_RGB32).save(folder.filePath("red.jpg")));
  for (const char* text : {"#Inventor V2.1 ascii\nTexture2 { filename \"red.jpg\" }\nCube { }\n",
                           "#VRML V2.0 utf8\nShape { appearance Appearance { texture ImageTexture { url \"red.jpg\" } "
                           "} geometry Box { } }\n"}) {
    QFile file(folder.filePath("scene.iv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    const SceneFile scene = readScene(file.fileName().toStdString(), pictureDecoder());
    ASSERT_TRUE(scene.root);
    EXPECT_TRUE(scene.diagnostics.empty()) << toText(scene.diagnostics.front());
    const QImage picture = drawOffscreen(scene.root.get(), 200, 200);
    int red = 0, blue = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        const QColor c = picture.pixelColor(x, y);
        red += c.red() > 3 * c.blue() ? 1 : 0;
        blue += c.blue() > 3 * c.red() ? 1 : 0;
      }
    }
    EXPECT_GT(red, 1000) << text;
    EXPECT_GT(blue, 1000) << text;
  }
}

}  // namespace
}  // namespace haptiv
