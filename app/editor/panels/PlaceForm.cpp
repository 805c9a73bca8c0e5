#include "app/editor/panels/PlaceForm.h"

#include <QLabel>
#include <QtMath>

namespace haptiv {
namespace {

constexpr double kCentimetres = 100;  // shown per metre

}  // namespace

PlaceForm::PlaceForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (int i = 0; i < 3; ++i) {
    const QChar axis("xyz"[i]);
    position_[i] = add(*form_, QString("Position ") + axis, QString("position%1Field").arg(axis.toUpper()),
                       {" cm", -1e5, 1e5, 1, 2}, "move", [i](ShapeFrame& frame, double shown) {
                         Vector3 centre = frame.centre();
                         centre[i] = shown / kCentimetres;
                         frame.setCentre(centre);
                       });
    position_[i]->setToolTip("Of the middle of the shape, in the scene");
  }
  for (int i = 0; i < 3; ++i) {
    const QChar axis("xyz"[i]);
    size_[i] =
        add(*form_, QString("Size ") + axis, QString("size%1Field").arg(axis.toUpper()),
            {" cm", ShapeFrame::kMinSize * kCentimetres, 1e5, 1, 2}, "resizing", [i](ShapeFrame& frame, double shown) {
              Vector3 size = frame.size();
              size[i] = shown / kCentimetres;
              frame.setSize(size);
            });
    size_[i]->setToolTip("Full length along the shape's own axis");
  }
  rotation_ = add(*form_, "Rotation", "rotationField", {" °", -360, 360, 5, 2}, "turn",
                  [](ShapeFrame& frame, double shown) { frame.setYaw(qDegreesToRadians(shown)); });
  rotation_->setToolTip("About the upright axis");
}

NumberField* PlaceForm::add(QFormLayout& form, const QString& title, const QString& name,
                            const NumberField::Format& format, const QString& text, const Change& change) {
  auto* number = new NumberField(format);
  number->setObjectName(name);
  number->setAccessibleName(title);
  form.addRow(title, number);
  connect(number, &NumberField::editingFinished, this, &PlaceForm::gestureEnded);
  connect(number, qOverload<double>(&NumberField::valueChanged), this,
          [=, this](double shown) { emit edited([=](ShapeFrame& frame) { change(frame, shown); }, text); });
  return number;
}

void PlaceForm::show(const ShapeFrame& frame, const QString& shape) {
  const bool isSphere = shape == "Sphere";
  const bool isBox = shape == "Cube";
  const std::array<QString, 3> titles = {isBox ? "Size x" : "Diameter", isBox ? "Size y" : "Height", "Size z"};
  const std::array<bool, 3> isShown = {true, !isSphere, isBox};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    position_[i]->show(frame.centre()[axis] * kCentimetres);
    size_[i]->show(frame.size()[axis] * kCentimetres);
    auto* label = static_cast<QLabel*>(form_->labelForField(size_[i]));
    label->setText(titles[i]);
    label->setVisible(isShown[i]);
    size_[i]->setVisible(isShown[i]);
  }
  rotation_->show(qRadiansToDegrees(frame.yaw()));
}

}  // namespace haptiv

#include "moc_PlaceForm.cpp"
