#pragma once

#include <Inventor/fields/SoField.h>

#include <memory>
#include <string>

#include "app/editor/commands/FieldConnection.h"

namespace haptiv {

/// A value of a field, apart from any node; remembers too whether the field stood at its default and where it had its
/// value from, so that a graph whose edits are undone is written as it was.
class FieldValue {
 public:
  /// The value that the field has now.
  explicit FieldValue(const SoField& field);
  /// Parses Inventor text. Throws std::invalid_argument where it is no value of such a field.
  FieldValue(const SoField& field, const std::string& text);
  /// FieldValue::of<SoSFFloat>(field, 2000.f)
  template <typename Field, typename Value>
  static FieldValue of(const SoField& field, const Value& value) {
    FieldValue made(field);
    static_cast<Field&>(*made.value_).setValue(value);
    made.isDefault_ = false;
    return made;
  }

  /// The field takes this value and this takes the field's.
  void exchangeWith(SoField& field);
  bool isSameAs(const SoField& field) const;

 private:
  std::unique_ptr<SoField> value_;
  bool isDefault_ = false;
  FieldConnection connection_;
};

}  // namespace haptiv
