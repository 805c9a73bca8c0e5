#pragma once

#include <optional>
#include <string_view>

#include "scenegraph/Diagnostic.h"
#include "scenegraph/reading/text/SceneTokenizer.h"

namespace haptiv {

/// Where Coin takes a scene to be at its end: between nodes, whatever cannot begin one.
/// @param word  just before, which may be a keyword
bool endsScene(const SceneToken& token, const std::optional<SceneToken>& word);

/// What is to be said of that: an error where nodes are lost, else a warning. Without file.
/// @param rest  of the text, after the token
Diagnostic endOfScene(const SceneToken& token, const std::optional<SceneToken>& word, bool hasNodes,
                      std::string_view rest);

/// An error: a word that no bracket follows. Without file.
Diagnostic wordThatIsNoNode(const SceneToken& word);

}  // namespace haptiv
