#pragma once

#include <QString>

namespace haptiv {

/// The folder for the logs of sessions run in the window: "Haptiv sessions" in the user's documents.
QString logFolder();

/// A name for a new log there, from the scene's name and the time; creates the folder. Throws std::runtime_error where
/// that cannot be done.
QString newLogPath(const QString& scenePath);

}  // namespace haptiv
