#pragma once

#include <QIcon>
#include <QPainter>
#include <functional>

namespace haptiv {

/// The side of the square on which icons are drawn [pixels]; they are shown at any size.
inline constexpr int kIconSide = 48;

/// An icon in plain strokes; `draw` gets an antialiased painter with the pen that all icons share.
QIcon strokeIcon(const std::function<void(QPainter&)>& draw);

}  // namespace haptiv
