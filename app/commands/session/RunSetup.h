#pragma once

#include "app/commands/scene/LoadedScene.h"
#include "app/commands/session/RunOptions.h"
#include "app/session/Session.h"

namespace haptiv {

/// The session that the options ask for, on a scene without errors. Throws std::runtime_error: what of it cannot be
/// had, and what to do.
SessionSetup setUp(const RunOptions& options, const LoadedScene& loaded);

/// How long it lasts [s]. Throws CommandFailure (kWrongUsage) where that is less than a tick.
double lengthOf(const RunOptions& options, const SessionSetup& setup);

}  // namespace haptiv
