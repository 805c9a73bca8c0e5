#pragma once

#include "app/bench/BenchRun.h"

namespace haptiv {

/// A ball slides over a sphere of a million triangles, in three sizes; the exact sphere says what it should feel. Part
/// of the collision bench.
void benchMesh(BenchRun& run);

}  // namespace haptiv
