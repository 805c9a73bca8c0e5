#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace haptiv {

/// A name for a log, in a folder of its own on the disk that holds temporary files. At the end the folder is removed,
/// however that comes, with what a session has put beside its log.
class TemporaryLog {
 public:
  TemporaryLog() {
    std::string folder = std::filesystem::temp_directory_path() / "haptiv-bench-XXXXXX";
    if (!::mkdtemp(folder.data())) throw std::runtime_error("cannot make a folder " + folder + ": make room there");
    folder_ = folder;
  }
  ~TemporaryLog() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryLog(const TemporaryLog&) = delete;
  TemporaryLog& operator=(const TemporaryLog&) = delete;
  std::filesystem::path path() const { return folder_ / "log.h5"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace haptiv
