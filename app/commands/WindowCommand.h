#pragma once

#include <string>

namespace haptiv {

/// `haptiv [SCENE or LOG]`: the desktop application; empty: with a new scene. argc and argv are the program's own.
/// Throws CommandFailure (kCouldNot) that says what to do instead where there is no display.
int openWindow(int argc, char** argv, const std::string& sceneOrLog);

}  // namespace haptiv
