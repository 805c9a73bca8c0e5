#pragma once

#include <Inventor/SbBasic.h>
#include <Inventor/SbMatrix.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scenegraph/compiling/MetNodes.h"
#include "scenegraph/compiling/PathIds.h"
#include "scenegraph/compiling/ShapeOrigin.h"

class SoNode;
class SoSeparator;

namespace haptiv {

class SoHapticProperty;

/// All that what a plain Separator comes to depends on, beyond itself.
struct Surroundings {
  PathIds::Way way = 0;                        ///< to the group that holds it
  SbMatrix toW;                                ///< from the coordinates before it
  const SoHapticProperty* property = nullptr;  ///< in force before it; null: none
  SbUniqueId propertyVersion = 0;              ///< Coin's number of its contents

  bool operator==(const Surroundings&) const = default;
};

/// What the plain Separators of the compilation before came to: an edit of one wall does not read all others again.
/// Coin gives a node a new number whenever it, or a node below it, is changed: equal numbers are equal contents.
/// Thread: GUI.
class KnownSeparators {
 public:
  struct Shape {
    PathIds::Place place = 0;
    bool isZone = false;
    ShapeOrigin origin;
  };
  struct Property {
    const SoHapticProperty* node = nullptr;
    MetNodes::Place place = 0;
  };
  /// Its numbers count from the first of each in the whole compilation.
  struct Separator {
    const SoSeparator* node = nullptr;
    SbUniqueId version = 0;  ///< Coin's number of its contents
    std::uint32_t surroundings = 0;
    std::uint32_t firstWall = 0, firstZone = 0;  ///< in the scene
    std::uint32_t firstShape = 0, shapes = 0;
    std::uint32_t firstProperty = 0, properties = 0;
  };

  /// A compilation begins. What the one before has noted can be found, and is to be noted again.
  void begin();
  /// Nothing can be found by the next compilation: the scene of this one is of no use.
  void forget() { now_ = {}; }

  /// What it came to; null: not known, or changed. They are to be asked for in the order of the compilation before,
  /// as far as it still holds.
  const Separator* find(const SoSeparator& node, const Surroundings& around);
  std::span<const Shape> shapesOf(const Separator& known) const;
  std::span<const Property> propertiesOf(const Separator& known) const;

  /// Notes one for the next compilation.
  void note(const SoSeparator& node, const Surroundings& around, std::size_t firstWall, std::size_t firstZone,
            std::span<const Shape> shapes, std::span<const Property> properties);

 private:
  struct Notes {
    std::vector<Separator> separators;
    std::vector<Shape> shapes;
    std::vector<Property> properties;
    std::vector<Surroundings> surroundings;
  };
  bool standsIn(const Surroundings& around, std::uint32_t surroundingsBefore);

  Notes before_, now_;
  std::size_t next_ = 0;  ///< of before_, most likely to be asked for
  Surroundings compared_;
  std::optional<std::uint32_t> comparedWith_;  ///< surroundings of before_ that are the same as compared_
};

}  // namespace haptiv
