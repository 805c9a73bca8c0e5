#pragma once

#include <filesystem>
#include <string>
#include <string_view>

class SoSeparator;

namespace haptiv {

/// Writes the graph to a file: wholly or not at all. Returns the text. Throws std::runtime_error that says why.
std::string saveScene(SoSeparator* root, const std::filesystem::path& path);
/// The same of any text.
void saveText(std::string_view text, const std::filesystem::path& path);

}  // namespace haptiv
