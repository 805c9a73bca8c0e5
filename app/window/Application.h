#pragma once

#include <QString>

namespace haptiv {

/// Opens the desktop application with a scene (.iv) or a session log (.h5) and runs it until it is closed.
/// Needs a display. Returns the process's exit code.
int runApplication(int argc, char** argv, const QString& sceneOrLog);

}  // namespace haptiv
