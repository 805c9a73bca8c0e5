#pragma once

namespace haptiv {

/// Runs `haptiv` with these arguments; the window where no command is given. Never throws.
/// Returns an ExitCode. What went wrong is told on stderr; with --json, stdout gets one object and nothing else.
int runCommandLine(int argc, char** argv) noexcept;

}  // namespace haptiv
