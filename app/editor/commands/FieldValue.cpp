#include "app/editor/commands/FieldValue.h"

#include <Inventor/SbName.h>
#include <Inventor/SbString.h>

#include <stdexcept>

namespace haptiv {
namespace {

std::unique_ptr<SoField> copyOf(const SoField& field) {
  std::unique_ptr<SoField> copy(static_cast<SoField*>(field.getTypeId().createInstance()));
  copy->copyFrom(field);
  return copy;
}

}  // namespace

FieldValue::FieldValue(const SoField& field) : value_(copyOf(field)), isDefault_(field.isDefault()) {}

FieldValue::FieldValue(const SoField& field, const std::string& text) : FieldValue(field) {
  if (!value_->set(text.c_str())) {
    throw std::invalid_argument("\"" + text + "\" is no " + field.getTypeId().getName().getString() +
                                ": write it as in an Inventor file.");
  }
  isDefault_ = false;
}

void FieldValue::exchangeWith(SoField& field) {
  std::unique_ptr<SoField> before = copyOf(field);
  const bool wasDefault = field.isDefault();
  const FieldConnection wasConnected = FieldConnection::cut(field);
  field.copyFrom(*value_);
  field.setDefault(isDefault_);
  connection_.restore(field);
  value_ = std::move(before);
  isDefault_ = wasDefault;
  connection_ = wasConnected;
}

bool FieldValue::isSameAs(const SoField& field) const {
  return isDefault_ == field.isDefault() && value_->isSame(field);
}

}  // namespace haptiv
