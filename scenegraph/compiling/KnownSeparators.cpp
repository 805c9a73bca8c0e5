#include "scenegraph/compiling/KnownSeparators.h"

#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <utility>

namespace haptiv {

void KnownSeparators::begin() {
  before_ = std::exchange(now_, {});
  now_.separators.reserve(before_.separators.size() + 16);
  now_.shapes.reserve(before_.shapes.size() + 16);
  now_.properties.reserve(before_.properties.size() + 16);
  next_ = 0;
  comparedWith_.reset();
}

bool KnownSeparators::standsIn(const Surroundings& around, std::uint32_t surroundingsBefore) {
  if (comparedWith_ == surroundingsBefore && compared_ == around) return true;
  if (before_.surroundings[surroundingsBefore] != around) return false;
  compared_ = around;
  comparedWith_ = surroundingsBefore;
  return true;
}

const KnownSeparators::Separator* KnownSeparators::find(const SoSeparator& node, const Surroundings& around) {
  constexpr std::size_t kAhead = 64;  // so many may have been taken away in one place
  const std::size_t end = std::min(next_ + kAhead, before_.separators.size());
  for (std::size_t i = next_; i < end; ++i) {
    const Separator& known = before_.separators[i];
    if (known.node != &node) continue;
    next_ = i + 1;
    const bool isSame = known.version == node.getNodeId() && standsIn(around, known.surroundings);
    return isSame ? &known : nullptr;
  }
  return nullptr;
}

std::span<const KnownSeparators::Shape> KnownSeparators::shapesOf(const Separator& known) const {
  return std::span(before_.shapes).subspan(known.firstShape, known.shapes);
}

std::span<const KnownSeparators::Property> KnownSeparators::propertiesOf(const Separator& known) const {
  return std::span(before_.properties).subspan(known.firstProperty, known.properties);
}

void KnownSeparators::note(const SoSeparator& node, const Surroundings& around, std::size_t firstWall,
                           std::size_t firstZone, std::span<const Shape> shapes, std::span<const Property> properties) {
  if (now_.surroundings.empty() || now_.surroundings.back() != around) now_.surroundings.push_back(around);
  const auto number = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  now_.separators.push_back({&node, node.getNodeId(), number(now_.surroundings.size() - 1), number(firstWall),
                             number(firstZone), number(now_.shapes.size()), number(shapes.size()),
                             number(now_.properties.size()), number(properties.size())});
  now_.shapes.insert(now_.shapes.end(), shapes.begin(), shapes.end());
  now_.properties.insert(now_.properties.end(), properties.begin(), properties.end());
}

}  // namespace haptiv
