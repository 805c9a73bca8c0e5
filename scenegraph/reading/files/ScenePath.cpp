#include "scenegraph/reading/files/ScenePath.h"

#include <algorithm>
#include <cctype>

namespace haptiv {
namespace {

namespace fs = std::filesystem;
using Verdict = NamedFile::Verdict;

/// Whether a name is an address: "http" of "http://...", "urn" of "urn:...", "C" of "C:\...".
bool hasScheme(std::string_view name) {
  const auto colon = name.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  const auto isLetter = [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; };
  return std::ranges::all_of(name.substr(0, colon), isLetter);
}

bool isInside(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

fs::path orHere(const fs::path& folder) {
  return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

NamedFile judgeName(const std::string& name, const fs::path& folder, const fs::path& home) {
  const std::string quoted = "\"" + name.substr(0, 200) + "\"";
  std::error_code error;
  const bool isAddress = hasScheme(name);
  const fs::path target = isAddress ? fs::path() : fs::weakly_canonical(orHere(folder) / fs::path(name), error);
  if (!isAddress && error)
    return {Verdict::forbidden,
            {},
            quoted + " cannot be looked up (" + error.message() + "): name a file beside the scene"};
  if (isAddress || !fs::exists(target, error))
    return {Verdict::missing, {}, quoted + " is not there: copy the file beside the scene and name it without a path"};
  if (fs::path(name).is_absolute() || !isInside(target, fs::weakly_canonical(orHere(home), error))) {
    return {Verdict::forbidden,
            {},
            quoted + " is outside of the scene's folder: copy the file there and name it without a path"};
  }
  if (!fs::is_regular_file(target, error))
    return {Verdict::forbidden, {}, quoted + " is not a regular file: name a file"};
  return {Verdict::inside, target, {}};
}

}  // namespace haptiv
