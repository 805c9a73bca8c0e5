#pragma once

#include <QPen>
#include <QPointF>

class QPainter;

namespace haptiv {

/// How the curves of style 0, 1, 2 ... look: told apart by colour, by dashes and by symbol, so that print in grey and
/// eyes that see no colours can too. Counted round.
QPen linePen(int style);

/// The style's symbol at a place.
void drawMarker(QPainter& painter, int style, const QPointF& at);

}  // namespace haptiv
