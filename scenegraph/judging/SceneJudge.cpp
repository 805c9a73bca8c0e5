#include "scenegraph/judging/SceneJudge.h"

#include <iterator>

#include "scenegraph/judging/Rules.h"

namespace haptiv {

Diagnostics judgeScene(const JudgedScene& judged) {
  Diagnostics all;
  const auto append = [&](Diagnostics found) {
    all.insert(all.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
    return !found.empty();
  };
  append(judgeReachOfHome(judged));
  append(judgeHomeInWall(judged));
  append(judgeStability(judged));
  append(judgeAnchors(judged));
  append(judgeLabels(judged));
  // In another unit everything is too far and too thin: one warning says it.
  if (append(judgeUnits(judged))) return all;
  append(judgeThickness(judged));
  append(judgeZonesInReach(judged));
  return all;
}

}  // namespace haptiv
