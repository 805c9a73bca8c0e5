#pragma once

#include "haptics/index/TreeOrigin.h"
#include "haptics/index/TreePlan.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/scene/KeptShapes.h"

namespace haptiv {

/// Makes the indices of a scene that is edited again and again. They are, bit for bit, those of computeBounds; where
/// most shapes were kept, in a fraction of the time. Thread: any one.
class SceneIndexer {
 public:
  /// Of the first version, or of one of which nothing was kept.
  void index(HapticScene& scene);
  /// @param before  the scene that was indexed last
  /// @param walls, zones  what is known to have been kept; what stands between two runs is compared
  void index(HapticScene& scene, const HapticScene& before, const KeptRuns& walls, const KeptRuns& zones);

 private:
  /// What is known of an index beyond what the servo reads.
  struct Plan {
    TreePlan tree;
    BoundsOfAll bounds;
  };
  class Update;

  Plan walls_, zones_;
};

}  // namespace haptiv
