#include "scenegraph/reading/text/SceneEnd.h"

#include <Inventor/SbName.h>

#include <string>

namespace haptiv {
namespace {

using Kind = SceneToken::Kind;

std::string quoted(const SceneToken& token) {
  return "\"" + std::string(token.text.substr(0, 60)) + "\"";
}

}  // namespace

bool endsScene(const SceneToken& token, const std::optional<SceneToken>& word) {
  if (word) return token.kind != Kind::open;
  return token.kind != Kind::word || !SbName::isIdentStartChar(token.text.front());
}

Diagnostic endOfScene(const SceneToken& token, const std::optional<SceneToken>& word, bool hasNodes,
                      std::string_view rest) {
  if (word || !hasNodes) return wordThatIsNoNode(word ? *word : token);
  const bool isLost = token.kind == Kind::open || rest.find('{') != std::string_view::npos;
  const bool isBracket = token.kind == Kind::close || token.kind == Kind::closeList;
  const std::string message =
      quoted(token) + (isBracket ? " closes nothing" : " is no node") +
      (isLost ? ", and the nodes after it would not be read: remove it, or open the bracket before"
              : ", and nothing after it is read: remove it");
  return {isLost ? Diagnostic::Severity::error : Diagnostic::Severity::warning, {}, token.line, {}, message, nullptr};
}

Diagnostic wordThatIsNoNode(const SceneToken& word) {
  return {Diagnostic::Severity::error,
          {},
          word.line,
          {},
          quoted(word) + " is no node: a scene is made of Keyword { ... }",
          nullptr};
}

}  // namespace haptiv
