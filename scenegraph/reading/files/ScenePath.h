#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace haptiv {

/// A file that a scene names, and whether the scene may have it opened.
struct NamedFile {
  enum class Verdict {
    inside,     ///< a regular file in the folder of the scene that the user named, or below it: may be opened
    missing,    ///< no such file, or an address in the net, which is never asked
    forbidden,  ///< something is there, outside of the folder or no regular file
  };
  Verdict verdict = Verdict::missing;
  std::filesystem::path path;  ///< canonical, where it is inside
  std::string why;             ///< what keeps it from being opened, and what to do; empty where nothing does
};

/// @param name    as it stands in the scene
/// @param folder  of the file in which it stands: names are relative to it
/// @param home    of the scene that the user named: nothing outside is opened, whatever links or .. lead there
NamedFile judgeName(const std::string& name, const std::filesystem::path& folder, const std::filesystem::path& home);

}  // namespace haptiv
