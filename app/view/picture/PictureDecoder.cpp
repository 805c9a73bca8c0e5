#include "app/view/picture/PictureDecoder.h"

#include <QBuffer>
#include <QImageReader>
#include <algorithm>
#include <array>
#include <stdexcept>

namespace haptiv {
namespace {

constexpr std::array<const char*, 4> kFormats = {"png", "jpeg", "gif", "bmp"};
constexpr int kLargest = 8192;  // [pixels] across, of the file
constexpr int kMost = 2048;     // of the picture

QImage read(QBuffer& file) {
  QImageReader reader(&file);
  reader.setDecideFormatFromContent(true);
  if (std::find(kFormats.begin(), kFormats.end(), reader.format()) == kFormats.end())
    throw std::runtime_error("it is no PNG, JPEG, GIF or BMP: convert it");
  const QSize size = reader.size();
  if (size.width() > kLargest || size.height() > kLargest)
    throw std::runtime_error("it is larger than 8192 pixels across: make it smaller");
  const QImage image = reader.read();
  if (image.isNull()) throw std::runtime_error("it is damaged: " + reader.errorString().toStdString());
  return image;
}

// Pixel by pixel: Qt converts large images in threads, and a child process has none of its parent's.
Picture decode(const std::string& contents) {
  QByteArray bytes = QByteArray::fromRawData(contents.data(), static_cast<int>(contents.size()));
  QBuffer file(&bytes);
  file.open(QIODevice::ReadOnly);
  const QImage image = read(file);
  const int step = std::max(1, (std::max(image.width(), image.height()) + kMost - 1) / kMost);
  Picture picture;
  picture.width = static_cast<short>(std::max(1, image.width() / step));
  picture.height = static_cast<short>(std::max(1, image.height() / step));
  picture.components = image.hasAlphaChannel() ? 4 : 3;
  for (int y = picture.height - 1; y >= 0; --y) {
    for (int x = 0; x < picture.width; ++x) {
      const QRgb pixel = image.pixel(x * step, y * step);
      for (const int part : {qRed(pixel), qGreen(pixel), qBlue(pixel)}) picture.pixels += static_cast<char>(part);
      if (picture.components == 4) picture.pixels += static_cast<char>(qAlpha(pixel));
    }
  }
  return picture;
}

}  // namespace

DecodePicture pictureDecoder() {
  for (const char* format : kFormats) {
    QBuffer nothing;
    nothing.open(QIODevice::ReadOnly);
    QImageReader(&nothing, format).canRead();
  }
  return decode;
}

}  // namespace haptiv
