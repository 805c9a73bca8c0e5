#include "app/dexterity/EllipsoidBoxes.h"

#include <QCheckBox>
#include <QPixmap>
#include <QVBoxLayout>

namespace haptiv {
namespace {

QIcon swatch(const SbColor& color) {
  QPixmap pixmap(12, 12);
  pixmap.fill(QColor::fromRgbF(color[0], color[1], color[2]));
  return pixmap;
}

}  // namespace

EllipsoidBoxes::EllipsoidBoxes(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  add(Manipulability::translational, "translationalEllipsoid", tr("Translational ellipsoid"),
      tr("Translation: 1 m/s is %1 m long").arg(DexterityFigure::kMetresPerSpeed));
  add(Manipulability::rotational, "rotationalEllipsoid", tr("Rotational ellipsoid"),
      tr("Rotation: 1 rad/s is %1 m long").arg(DexterityFigure::kMetresPerTurning));
}

void EllipsoidBoxes::add(Manipulability which, const char* name, const QString& title, const QString& legend) {
  auto* action = new QAction(title, this);
  action->setObjectName(QString(name) + "Action");
  action->setCheckable(true);
  actions_[static_cast<std::size_t>(which)] = action;
  auto* box = new QCheckBox(legend);
  box->setObjectName(QString(name) + "Box");
  box->setIcon(swatch(DexterityFigure::colorOf(which)));
  box->setToolTip(tr("%1 at the wrist: the tool's velocities at joint rates of norm 1 rad/s;\n"
                     "lengths are metres of the device")
                      .arg(title));
  layout()->addWidget(box);
  connect(box, &QCheckBox::toggled, action, &QAction::setChecked);
  connect(action, &QAction::toggled, box, &QCheckBox::setChecked);
  connect(action, &QAction::toggled, this, [this, which](bool visible) { emit switched(which, visible); });
}

}  // namespace haptiv

#include "moc_EllipsoidBoxes.cpp"
