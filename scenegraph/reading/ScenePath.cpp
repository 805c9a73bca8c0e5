#include "scenegraph/reading/ScenePath.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace haptiv {
namespace {

namespace fs = std::filesystem;

/// "http" of "http://...", "javascript" of "javascript: ..."; empty where there is none.
std::string schemeOf(std::string_view path) {
  const auto colon = path.find(':');
  if (colon == std::string_view::npos || colon == 0) return {};
  const auto letters = path.substr(0, colon);
  const auto isLetter = [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; };
  return std::ranges::all_of(letters, isLetter) ? std::string(letters) : std::string();
}

bool isInside(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

bool namesFiles(std::string_view keyword, std::string_view field) {
  if (keyword.find("Anchor") != std::string_view::npos) return false;  // where a click leads; never opened here
  static constexpr std::array<std::string_view, 4> kFields = {"filename", "filenames", "url", "sourceProgram"};
  return std::ranges::find(kFields, field) != kFields.end() || field.ends_with("Url") ||
         field.starts_with("filename");  // the six sides of a TextureCubeMap
}

std::string pathFault(std::string_view path, const fs::path& folder) {
  if (path.find('\n') != std::string_view::npos) return {};  // a shader's own text, not a name
  const std::string scheme = schemeOf(path);
  if (scheme == "javascript" || scheme == "vrmlscript" || scheme == "ecmascript") return {};  // never run
  const std::string quoted = "\"" + std::string(path.substr(0, 200)) + "\"";
  if (!scheme.empty()) return quoted + " is not a file beside the scene: copy it there and name it without a path";

  std::error_code error;
  const fs::path home = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  const fs::path target = fs::weakly_canonical(home / fs::path(path), error);
  if (error) return quoted + " cannot be looked up (" + error.message() + "): name a file in the scene's folder";
  if (fs::path(path).is_absolute() || !isInside(target, home)) {
    return quoted + " is outside of the scene's folder: copy the file there and name it without a path";
  }
  if (!path.empty() && fs::exists(target, error) && !fs::is_regular_file(target, error)) {
    return quoted + " is not a regular file: name a file";
  }
  return {};
}

}  // namespace haptiv
