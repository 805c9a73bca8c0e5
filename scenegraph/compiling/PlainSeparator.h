#pragma once

#include <Inventor/SbMatrix.h>

#include <vector>

#include "haptics/scene/HapticScene.h"

class SoNode;
class SoSeparator;

namespace haptiv {

class SoHapticProperty;

/// A Separator that holds nothing but everyday nodes: how shapes feel, where they stand, what they look like, and
/// shapes of the exact kinds. Large scenes are made of them, and reading one here takes a third of the time that Coin
/// takes to go through it. What comes out is the same, bit for bit. Thread: GUI.
class PlainSeparator {
 public:
  struct Felt {
    const SoNode* node = nullptr;
    const SoHapticProperty* property = nullptr;
    SbMatrix toW;
    Shape shape;
  };

  /// False: it holds something that only Coin can go through, or that has a fault.
  /// @param toW       from the coordinates of what stands before the Separator
  /// @param property  in force before the Separator; null: none
  bool read(const SoSeparator& separator, const SbMatrix& toW, const SoHapticProperty* property);

  std::vector<Felt>& felt() { return felt_; }                                             ///< to be moved from
  const std::vector<const SoHapticProperty*>& properties() const { return properties_; }  ///< that it holds

 private:
  std::vector<Felt> felt_;
  std::vector<const SoHapticProperty*> properties_;
};

}  // namespace haptiv
