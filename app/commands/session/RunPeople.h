#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/commands/session/LiveRun.h"

/// What a person holds in a session of `haptiv run`, as the command line names it.
namespace haptiv {

/// Makes the Falcon of that name; tells on stderr what the operator has to do until it is ready.
/// @param firmware  file; empty: where it is looked for
std::function<std::unique_ptr<HapticDevice>()> falconOf(const std::string& device, const std::string& firmware,
                                                        const DeviceDescription& description);

/// Opens the SpaceMouse of that name, to lead the hand; empty where the hand is none. Throws std::runtime_error: what
/// is wrong with it, and what to do.
LiveOperator operatorOf(const std::string& hand, const SessionSetup& setup);

}  // namespace haptiv
