#include "tests/architecture/Sources.h"

#include <filesystem>
#include <fstream>
#include <regex>

namespace haptiv::testing {

std::vector<Found> find(const std::string& folder, const std::string& pattern) {
  namespace fs = std::filesystem;
  const fs::path root = HAPTIV_SOURCE_DIR;
  const std::regex wanted(pattern);
  std::vector<Found> all;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream stream(entry.path());
    std::string text;
    std::smatch match;
    for (int line = 1; std::getline(stream, text); ++line) {
      if (std::regex_search(text, match, wanted))
        all.push_back({fs::relative(entry.path(), root).string(), line, match[1]});
    }
  }
  return all;
}

std::vector<Found> includesBelow(const std::string& folder) {
  return find(folder, R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
}

}  // namespace haptiv::testing
