#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv::testing {

inline std::filesystem::path sourceDir() {
  return HAPTIV_SOURCE_DIR;
}

/// The first line of a scene.
inline const std::string kHeader = "#Inventor V2.1 ascii\n";

void put(const std::filesystem::path& file, const std::string& text);
std::string contentsOf(const std::filesystem::path& file);

/// As Coin cuts the scene.
int trianglesOf(const SceneFile& scene);

/// The .iv files of a folder, in the order of their names.
std::vector<std::filesystem::path> scenesIn(const std::filesystem::path& folder);

/// For tests that have a file as their parameter.
std::string nameOfFile(const ::testing::TestParamInfo<std::filesystem::path>& file);

/// Every diagnostic as a line of text.
std::string textOf(const Diagnostics& diagnostics);

/// Reads `body` with the header before it; line 1 is the header. The text must be readable.
SceneFile read(const std::string& body);

/// Reads and compiles `body`, with a tool in front of it on the header's own line.
CompiledScene compile(const std::string& body);

/// A folder of its own for a test's files; gone at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace haptiv::testing
