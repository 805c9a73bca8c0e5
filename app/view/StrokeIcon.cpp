#include "app/view/StrokeIcon.h"

#include <QPixmap>

namespace haptiv {

QIcon strokeIcon(const std::function<void(QPainter&)>& draw) {
  QPixmap pixmap(kIconSide, kIconSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(70, 78, 90), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  draw(painter);
  painter.end();
  return QIcon(pixmap);
}

}  // namespace haptiv
