#pragma once

#include <string>
#include <string_view>

namespace haptiv {

/// Writes a file wholly or not at all, also when the program is told to end meanwhile; what was there before stays
/// until then. Throws CommandFailure (kCouldNot) that says why it could not.
void writeWholly(const std::string& path, std::string_view bytes);

}  // namespace haptiv
