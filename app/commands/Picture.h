#pragma once

#include <QImage>
#include <string>

namespace haptiv {

/// Writes a PNG, wholly or not at all; into a device or pipe, in place. Throws CommandFailure (kCouldNot) that says why
/// it could not.
void savePicture(const QImage& picture, const std::string& path);

}  // namespace haptiv
