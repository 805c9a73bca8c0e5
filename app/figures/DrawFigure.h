#pragma once

#include <QImage>

#include "app/figures/Figure.h"

namespace haptiv {

inline constexpr int kFigureWidth = 1280;
inline constexpr int kFigureHeight = 720;

/// The figure on white. Needs a QApplication: OffscreenQt where there is no display. Thread: GUI.
/// The same figure gives the same picture.
QImage drawFigure(const Figure& figure, int width = kFigureWidth, int height = kFigureHeight);

}  // namespace haptiv
