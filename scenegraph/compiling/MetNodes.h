#pragma once

#include <cstdint>
#include <vector>

#include "scenegraph/compiling/FlatMap.h"

class SoNode;

namespace haptiv {

/// Which nodes a compilation has met already. Thread: GUI.
class MetNodes {
 public:
  using Place = std::uint32_t;  ///< names a node's address, for as long as this lives: quicker to ask by

  /// A compilation begins.
  void begin() { ++round_; }
  Place placeOf(const SoNode* node) {
    Place& next = places_[reinterpret_cast<std::uintptr_t>(node)];
    if (next == 0) {
      rounds_.push_back(0);
      next = static_cast<Place>(rounds_.size());
    }
    return next - 1;
  }
  /// Whether the compilation meets it for the first time.
  bool meet(Place place) {
    const bool isFirst = rounds_[place] != round_;
    rounds_[place] = round_;
    return isFirst;
  }

 private:
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> rounds_;  ///< by place: the compilation that met it last
  FlatMap<Place> places_;              ///< by address, one more each; 0: none yet
};

}  // namespace haptiv
