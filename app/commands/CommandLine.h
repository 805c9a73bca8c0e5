#pragma once

namespace haptiv {

/// The program's exit codes; scripts rely on them.
enum ExitCode { kGood = 0, kNotSo = 1, kWrongUsage = 2, kCouldNot = 3 };

/// Runs `haptiv` with these arguments; the window where no command is given. Never throws.
int runCommandLine(int argc, char** argv);

}  // namespace haptiv
