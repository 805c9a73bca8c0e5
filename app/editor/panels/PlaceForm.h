#pragma once

#include <QFormLayout>
#include <QWidget>
#include <array>
#include <functional>

#include "app/editor/edits/ShapeFrame.h"
#include "app/editor/panels/NumberField.h"

namespace haptiv {

/// Where a shape stands, how big it is and how it is turned. Says what the user wants changed.
class PlaceForm : public QWidget {
  Q_OBJECT
 public:
  explicit PlaceForm(QWidget* parent = nullptr);

  /// @param shape  its keyword: a sphere has one diameter, a cylinder and a cone a diameter and a height
  void show(const ShapeFrame& frame, const QString& shape);
  using QWidget::show;

 signals:
  void edited(const std::function<void(haptiv::ShapeFrame&)>& change, const QString& text);
  void gestureEnded();

 private:
  using Change = std::function<void(ShapeFrame&, double shown)>;
  NumberField* add(QFormLayout& form, const QString& title, const QString& name, const NumberField::Format& format,
                   const QString& text, const Change& change);

  QFormLayout* form_ = nullptr;
  std::array<NumberField*, 3> position_{};
  std::array<NumberField*, 3> size_{};
  NumberField* rotation_ = nullptr;
};

}  // namespace haptiv
