#pragma once

#include <string_view>

namespace haptiv {

/// Whether a node is one of the everyday ones, of which all that can make Coin crash is looked for by name: the
/// rehearsal, which doubles the time of reading, is for scenes that hold others.
bool isPlainNode(std::string_view keyword);

}  // namespace haptiv
