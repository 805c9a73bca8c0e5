#include "app/commands/WholeFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "app/commands/HeldSignals.h"
#include "app/commands/NamedFile.h"

namespace haptiv {

void writeWholly(const std::string& path, std::string_view bytes) {
  const HeldSignals whole;
  const std::string part = path + ".part";
  errno = 0;
  std::ofstream file(part, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file || std::rename(part.c_str(), path.c_str()) != 0) {
    const std::string why = errno ? std::strerror(errno) : "unknown error";
    std::remove(part.c_str());
    refuseToWrite(path, why);
  }
}

}  // namespace haptiv
