#include "scenegraph/writing/SceneSaver.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "scenegraph/writing/LastingText.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* what, const char* remedy) {
  throw std::runtime_error(path.string() + ": cannot be saved: " + what + " (" + std::strerror(errno) + "): " + remedy +
                           "; the file is as it was");
}

/// A file beside the one that is to be replaced; gone again unless it has taken its place.
class ReplacingFile {
 public:
  explicit ReplacingFile(const fs::path& target) : target_(target), name_(target.string() + ".XXXXXX") {
    descriptor_ = ::mkostemp(name_.data(), O_CLOEXEC);
    if (descriptor_ < 0) fail(target_, "no file can be made in its folder", "check the folder and its permissions");
  }
  ~ReplacingFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!done_) ::unlink(name_.c_str());
  }
  ReplacingFile(const ReplacingFile&) = delete;
  ReplacingFile& operator=(const ReplacingFile&) = delete;

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t count = ::write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(target_, "writing failed", "make room on the disk, or save elsewhere");
      text.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  /// Takes the permissions of the file it replaces, or those that a new file gets.
  void setMode() {
    struct stat before {};
    mode_t mode = 0;
    if (::stat(target_.c_str(), &before) == 0) {
      mode = before.st_mode & 07777;
    } else {
      const mode_t mask = ::umask(0);
      ::umask(mask);
      mode = 0666 & ~mask;
    }
    if (::fchmod(descriptor_, mode) != 0) fail(target_, "its permissions cannot be kept", "save elsewhere");
  }

  void takePlace() {
    if (::fsync(descriptor_) != 0) fail(target_, "writing failed", "make room on the disk, or save elsewhere");
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail(target_, "it cannot be replaced", "save elsewhere");
    done_ = true;
    const std::string folder = target_.has_parent_path() ? target_.parent_path().string() : ".";
    const int directory = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0) return;
    ::fsync(directory);  // the name too outlives a power cut; not every file system can, and the file is whole anyway
    ::close(directory);
  }

 private:
  fs::path target_;
  std::string name_;
  int descriptor_ = -1;
  bool done_ = false;
};

}  // namespace

std::string saveScene(SoSeparator* root, const fs::path& path) {
  std::string text = lastingText(root, path.string());
  saveText(text, path);
  return text;
}

void saveText(std::string_view text, const fs::path& path) {
  std::error_code error;
  fs::path target = fs::canonical(path, error);  // a link stays one: what it points to is replaced
  if (error) target = path;
  if (fs::exists(target, error)) {
    errno = EINVAL;
    if (!fs::is_regular_file(target, error)) fail(path, "it is not a regular file", "choose another name");
    if (::access(target.c_str(), W_OK) != 0) fail(path, "it is write-protected", "save under another name");
  }
  ReplacingFile replacement(target);
  replacement.write(text);
  replacement.setMode();
  replacement.takePlace();
}

}  // namespace haptiv
