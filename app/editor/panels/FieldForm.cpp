#include "app/editor/panels/FieldForm.h"

#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFRotation.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/fields/SoSFVec3f.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QtMath>
#include <cmath>

namespace haptiv {
namespace {

template <typename Field>
const Field* fieldOf(const SoNode& node, const char* name) {
  return dynamic_cast<const Field*>(node.getField(name));
}

template <typename Field>
const Field& as(const SoField& field) {
  return static_cast<const Field&>(field);
}

QString editorName(const FieldRow& row) {
  return QString("%1Field").arg(row.field);
}

double yawOf(const SbRotation& rotation) {
  SbVec3f x;
  rotation.multVec(SbVec3f(1, 0, 0), x);
  return qRadiansToDegrees(std::atan2(static_cast<double>(x[1]), static_cast<double>(x[0])));
}

SbRotation withYaw(const SbRotation& rotation, double degrees) {
  const double turn = qDegreesToRadians(degrees - yawOf(rotation));
  return rotation * SbRotation(SbVec3f(0, 0, 1), static_cast<float>(turn));
}

}  // namespace

FieldForm::FieldForm(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
}

void FieldForm::show(const SoNode* node) {
  const QString wanted = node ? keyword(*node) : QString();
  if (wanted != keyword_) build(wanted);
  if (!node) return;
  for (const auto& showOne : show_) showOne(*node);
}

void FieldForm::build(const QString& keyword) {
  keyword_ = keyword;
  show_.clear();
  delete content_;
  content_ = new QWidget(this);
  layout()->addWidget(content_);
  auto* form = new QFormLayout(content_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (const FieldRow& row : rowsFor(keyword)) addRow(*form, row);
}

NumberField* FieldForm::addNumber(QFormLayout& layout, const QString& title, const QString& name, const FieldRow& row) {
  auto* number = new NumberField(row.format);
  number->setObjectName(name);
  number->setToolTip(row.tip);
  number->setAccessibleName(title);
  layout.addRow(title, number);
  connect(number, &NumberField::editingFinished, this, &FieldForm::gestureEnded);
  return number;
}

void FieldForm::addVector(QFormLayout& layout, const FieldRow& row) {
  for (int i = 0; i < 3; ++i) {
    const QChar axis("xyz"[i]);
    auto* number =
        addNumber(layout, row.title + " " + axis, QString("%1%2Field").arg(row.field).arg(axis.toUpper()), row);
    connect(number, qOverload<double>(&NumberField::valueChanged), this, [this, row, i](double shown) {
      emit edited(row.field, [=](const SoField& field) {
        SbVec3f value = as<SoSFVec3f>(field).getValue();
        value[i] = static_cast<float>(shown / row.shownPerUnit);
        return FieldValue::of<SoSFVec3f>(field, value);
      });
    });
    show_.emplace_back([=](const SoNode& node) {
      const auto* field = fieldOf<SoSFVec3f>(node, row.field);
      if (field) number->show(static_cast<double>(field->getValue()[i]) * row.shownPerUnit);
    });
  }
}

void FieldForm::addScalar(QFormLayout& layout, const FieldRow& row) {
  auto* number = addNumber(layout, row.title, editorName(row), row);
  connect(number, qOverload<double>(&NumberField::valueChanged), this, [this, row](double shown) {
    emit edited(row.field, [=](const SoField& field) {
      return FieldValue::of<SoSFFloat>(field, static_cast<float>(shown / row.shownPerUnit));
    });
  });
  show_.emplace_back([=](const SoNode& node) {
    const auto* field = fieldOf<SoSFFloat>(node, row.field);
    if (field) number->show(static_cast<double>(field->getValue()) * row.shownPerUnit);
  });
}

void FieldForm::addYaw(QFormLayout& layout, const FieldRow& row) {
  auto* number = addNumber(layout, row.title, editorName(row), row);
  connect(number, qOverload<double>(&NumberField::valueChanged), this, [this, row](double shown) {
    emit edited(row.field, [=](const SoField& field) {
      return FieldValue::of<SoSFRotation>(field, withYaw(as<SoSFRotation>(field).getValue(), shown));
    });
  });
  show_.emplace_back([=](const SoNode& node) {
    if (const auto* field = fieldOf<SoSFRotation>(node, row.field)) number->show(yawOf(field->getValue()));
  });
}

void FieldForm::addToggle(QFormLayout& layout, const FieldRow& row) {
  auto* box = new QCheckBox(row.title);
  box->setObjectName(editorName(row));
  box->setToolTip(row.tip);
  layout.addRow(QString(), box);
  connect(box, &QCheckBox::toggled, this, [this, row](bool on) {
    emit edited(row.field, [=](const SoField& field) { return FieldValue::of<SoSFBool>(field, SbBool(on)); });
    emit gestureEnded();
  });
  show_.emplace_back([=](const SoNode& node) {
    const QSignalBlocker quiet(box);
    if (const auto* field = fieldOf<SoSFBool>(node, row.field)) box->setChecked(field->getValue());
  });
}

void FieldForm::addText(QFormLayout& layout, const FieldRow& row) {
  auto* line = new QLineEdit;
  line->setObjectName(editorName(row));
  line->setToolTip(row.tip);
  layout.addRow(row.title, line);
  connect(line, &QLineEdit::editingFinished, this, [this, row, line] {
    const QByteArray text = line->text().toUtf8();
    emit edited(row.field, [=](const SoField& field) {
      if (as<SoSFString>(field).getValue() == text.constData()) return FieldValue(field);
      return FieldValue::of<SoSFString>(field, SbString(text.constData()));
    });
    emit gestureEnded();
  });
  show_.emplace_back([=](const SoNode& node) {
    const auto* field = fieldOf<SoSFString>(node, row.field);
    const QString text = field ? QString::fromUtf8(field->getValue().getString()) : QString();
    if (line->text() != text) line->setText(text);
  });
}

void FieldForm::addRow(QFormLayout& layout, const FieldRow& row) {
  switch (row.kind) {
    case FieldRow::Kind::number:
      return addScalar(layout, row);
    case FieldRow::Kind::vector:
      return addVector(layout, row);
    case FieldRow::Kind::yaw:
      return addYaw(layout, row);
    case FieldRow::Kind::toggle:
      return addToggle(layout, row);
    case FieldRow::Kind::text:
      return addText(layout, row);
  }
}

}  // namespace haptiv

#include "moc_FieldForm.cpp"
