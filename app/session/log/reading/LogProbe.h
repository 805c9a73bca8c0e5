#pragma once

#include <chrono>
#include <filesystem>
#include <functional>

namespace haptiv {

/// Runs `read` in a child process first, because HDF5 can hang or crash on damaged files, and only there it may.
///
/// `read` reports trouble by throwing std::exception. Nothing that it does is seen in this process.
/// Throws std::runtime_error: with the same words where `read` threw, and "FILE: damaged ..." where the child took
/// longer than `patience` or crashed.
void probeInChild(const std::filesystem::path& file, const std::function<void()>& read, std::chrono::seconds patience);

}  // namespace haptiv
