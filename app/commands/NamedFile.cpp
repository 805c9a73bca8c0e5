#include "app/commands/NamedFile.h"

#include <QFileInfo>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "app/commands/ExitCode.h"

namespace haptiv {

void requireReadable(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw CommandFailure(kCouldNot, path + ": this is a folder; name a file in it");
  if (std::filesystem::is_fifo(path, ignored))  // opening one waits for who writes to it
    throw CommandFailure(kCouldNot, path + ": this is a pipe; name a file");
  if (!std::ifstream(path))
    throw CommandFailure(kCouldNot, path + ": cannot be read: " + std::strerror(errno) + "; check the path");
}

void requireWritable(const std::string& path) {
  const QFileInfo file(QString::fromStdString(path));
  const QFileInfo folder(file.absolutePath());
  if (file.isDir()) refuseToWrite(path, "this is a folder; name a file in it");
  if (!folder.isDir()) refuseToWrite(path, "there is no folder " + folder.filePath().toStdString() + "; make it first");
  if (file.exists() ? !file.isWritable() : !folder.isWritable())
    refuseToWrite(path, "permission denied; choose another folder");
}

void refuseToWrite(const std::string& path, const std::string& why) {
  throw CommandFailure(kCouldNot, path + ": cannot be written: " + why);
}

}  // namespace haptiv
