#pragma once

#include <QFormLayout>
#include <QWidget>
#include <functional>
#include <vector>

#include "app/editor/edits/Edits.h"
#include "app/editor/panels/FieldRows.h"

namespace haptiv {

/// The fields of a haptic node, with units. Changes nothing itself: it says what the user wants changed.
class FieldForm : public QWidget {
  Q_OBJECT
 public:
  explicit FieldForm(QWidget* parent = nullptr);

  /// Shows this node's values; null: nothing. Fields that have the keyboard stay where they are.
  void show(const SoNode* node);
  using QWidget::show;

 signals:
  void edited(const QString& field, const haptiv::NewValue& value);
  /// What is edited from here on is a new undo step.
  void gestureEnded();

 private:
  void build(const QString& keyword);
  void addRow(QFormLayout& layout, const FieldRow& row);
  void addScalar(QFormLayout& layout, const FieldRow& row);
  void addYaw(QFormLayout& layout, const FieldRow& row);
  void addToggle(QFormLayout& layout, const FieldRow& row);
  void addText(QFormLayout& layout, const FieldRow& row);
  void addVector(QFormLayout& layout, const FieldRow& row);
  NumberField* addNumber(QFormLayout& layout, const QString& title, const QString& name, const FieldRow& row);

  QString keyword_;
  QWidget* content_ = nullptr;
  std::vector<std::function<void(const SoNode&)>> show_;  ///< one for each editor
};

}  // namespace haptiv
