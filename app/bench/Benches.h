#pragma once

#include "app/bench/BenchRun.h"

namespace haptiv {

/// Walls: time in contact and in free motion at 100, 10k and 100k of them, in three sizes; the peer is a flat scan.
void benchCollision(BenchRun& run);
/// From the text of 100k walls to what the servo reads; and what an edit costs among 10k walls. Needs initSceneGraph.
void benchCompile(BenchRun& run);
/// A thousand edits in a row of a session that runs and is logged: the ticks that are missed meanwhile, and those that
/// are missed in the pauses between, when nothing is edited. Needs initSceneGraph.
void benchEdits(BenchRun& run);
/// A whole tick of the simulated arm among 10k walls.
void benchTick(BenchRun& run);
/// Joint rates by every strategy and solution, the Jacobian included; the peer is Orocos KDL, where it is built in.
void benchIk(BenchRun& run);
/// Ticks into a session log on the disk that holds temporary files.
void benchLog(BenchRun& run);
/// Which walls the simulated arm can show without shaking, by stiffness and damping.
void benchWall(BenchRun& run);

struct Bench {
  const char* name;
  void (*run)(BenchRun& run);
};

/// All there are, in the order in which they run.
inline constexpr Bench kBenches[] = {
    {"tick", benchTick},   {"collision", benchCollision}, {"ik", benchIk},     {"compile", benchCompile},
    {"edits", benchEdits}, {"log", benchLog},             {"wall", benchWall},
};

}  // namespace haptiv
