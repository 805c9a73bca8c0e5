#include "tests/app/commands/TestFolder.h"

#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace haptiv {

std::filesystem::path makeFolder() {
  std::string name = std::filesystem::temp_directory_path() / "haptiv-test-XXXXXX";
  if (!mkdtemp(name.data())) throw std::runtime_error(name + " cannot be made");
  return name;
}

std::string readFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string TestFolder::fullDevice() const {
  const std::string own = path_ / "full";
  if (geteuid() != 0) return "/dev/full";
  if (std::filesystem::exists(own) || mknod(own.c_str(), S_IFCHR | 0666, makedev(1, 7)) == 0) return own;
  throw std::runtime_error(own + ": a device cannot be made");
}

std::string TestFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

std::string wallScene(const std::string& surface, const std::string& more) {
  return R"(#Inventor V2.1 ascii
Separator {
  HapticTool { home 0.3 0 0 radius 0.01 mass 2 damping 5 }
)" + more +
         R"(
  Separator {
    DEF Stop HapticSurface { stiffness 2000 damping 20 label "stop" )" +
         surface + R"( }
    Translation { translation 0.3 0.25 0 }
    Cube { width 0.6 height 0.2 depth 0.6 }
  }
}
)";
}

std::string pushingHand() {
  return "t,x,y,z\n0,0.3,0,0\n1,0.3,0.2,0\n";
}

std::string data(const std::string& name) {
  return std::string(HAPTIV_SOURCE_DIR) + "/tests/data/" + name;
}

}  // namespace haptiv
