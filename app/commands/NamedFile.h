#pragma once

#include <string>

namespace haptiv {

/// Throws CommandFailure (kCouldNot) that says what hinders, unless `path` is a file that can be read.
void requireReadable(const std::string& path);

/// Throws CommandFailure (kCouldNot) where a file of this name plainly cannot be written: known before a long session
/// rather than after it.
void requireWritable(const std::string& path);

/// Throws CommandFailure (kCouldNot): a file could not be written, and why.
[[noreturn]] void refuseToWrite(const std::string& path, const std::string& why);

}  // namespace haptiv
