#pragma once

#include <memory>
#include <vector>

#include "app/session/Session.h"
#include "app/session/recording/FlightRecorder.h"
#include "device/simulated/SimulatedDevice.h"

/// What live and fast sessions are both built from.
namespace haptiv {

/// Throws std::runtime_error where a number of the scene is none.
void expectFeelable(const HapticScene& scene);

/// Throws std::invalid_argument or std::runtime_error where a session cannot be run with this set-up: what, and what to
/// do. Touches nothing.
void expectUsable(const SessionSetup& setup);

/// The hand of the set-up's file, in B.
std::unique_ptr<HandSource> scriptedHand(const SessionSetup& setup);

/// The simulated arm with the tool at home. Throws std::runtime_error where home is out of the arm's reach.
std::unique_ptr<SimulatedDevice> simulatedDevice(const SessionSetup& setup, std::unique_ptr<HandSource> hand);

/// What keeps the last ticks before a fault; null where the set-up has no place for it. Knows the first scene.
std::unique_ptr<FlightRecorder> flightRecorder(const SessionSetup& setup, const SessionHeader& header);

/// The head of the log; start and scheduling, which a fast run has not, are left empty.
SessionHeader headerOf(const SessionSetup& setup);

}  // namespace haptiv
