#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace haptiv {

/// A name for a log on the disk that holds temporary files; the file is removed at the end, however it comes.
class TemporaryFile {
 public:
  TemporaryFile()
      : path_(std::filesystem::temp_directory_path() / ("haptiv-bench-" + std::to_string(getpid()) + ".h5")) {}
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace haptiv
