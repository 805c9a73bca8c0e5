#include "scenegraph/reading/text/NodeAtLine.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "scenegraph/reading/text/DeclaredFields.h"

namespace haptiv {
namespace {

using Texts = std::vector<const TextNode*>;

/// What stands in a message as "WORD", 'WORD' or ``WORD'', as Coin has it.
std::set<std::string> quotedIn(const std::string& message) {
  static constexpr char kQuotes[] = "\"`'";
  std::set<std::string> words;
  for (std::size_t open = message.find_first_of(kQuotes); open != std::string::npos;) {
    const std::size_t first = message.find_first_not_of(kQuotes, open);
    const std::size_t close = message.find_first_of(kQuotes, first);
    if (close == std::string::npos) break;
    words.insert(message.substr(first, close - first));
    open = close;
  }
  return words;
}

/// The last one, where all others are around it; null where there are neighbours.
const TextNode* innermost(const SceneScan& scan, const Texts& texts) {
  if (texts.empty()) return nullptr;
  std::size_t outer = texts.size();
  const TextNode* first = scan.nodes.data();
  for (auto at = static_cast<std::size_t>(texts.back() - first); outer > 0; at = scan.nodes[at].parent) {
    if (texts[outer - 1] == first + at) --outer;
    if (scan.nodes[at].parent == TextNode::kNone) break;
  }
  return outer == 0 ? texts.back() : nullptr;
}

const TextNode* nodeMeant(const Diagnostic& diagnostic, const SceneScan& scan, bool vrml2) {
  const std::set<std::string> quoted = quotedIn(diagnostic.message);
  Texts there, named, owners;
  std::unordered_map<std::string, bool> isOwner;
  for (const TextNode& text : scan.nodes) {
    if (text.line > diagnostic.line || diagnostic.line > text.lastLine || !text.isNode()) continue;
    if (text.keyword == "Path") return &text;  // its indices come after its nodes
    there.push_back(&text);
    if (quoted.contains(text.keyword)) named.push_back(&text);
    const auto [known, isNew] = isOwner.try_emplace(text.keyword, false);
    if (isNew) known->second = hasFieldOf(text.keyword, vrml2, quoted);
    if (known->second) owners.push_back(&text);
  }
  if (!named.empty()) return innermost(scan, named);
  return innermost(scan, owners.empty() ? there : owners);
}

bool isPrototype(const TextNode& text) {
  return text.keyword.ends_with("PROTO");
}

/// The one that Coin has just read, and cannot find.
const TextNode* externalPrototype(const Diagnostic& diagnostic, const SceneScan& scan) {
  if (!diagnostic.message.starts_with("Error reading EXTERNPROTO")) return nullptr;
  const TextNode* last = nullptr;
  for (const TextNode& text : scan.nodes) {
    if (text.keyword == "EXTERNPROTO" && text.line <= diagnostic.line) last = &text;
  }
  return last;
}

/// The first one of the keyword, or the prototype that the message quotes.
const TextNode* firstMeant(const Diagnostic& diagnostic, const SceneScan& scan) {
  const std::set<std::string> quoted = quotedIn(diagnostic.message);
  const auto text = std::ranges::find_if(scan.nodes, [&](const TextNode& each) {
    return diagnostic.node.empty() ? isPrototype(each) && quoted.contains(each.name)
                                   : each.keyword.ends_with(diagnostic.node);
  });
  return text == scan.nodes.end() ? nullptr : &*text;
}

}  // namespace

Diagnostics located(Diagnostics said, const SceneScan& scan, bool vrml2) {
  for (Diagnostic& each : said) {
    const bool hasLine = each.line > 0;
    const TextNode* prototype = externalPrototype(each, scan);
    const TextNode* text = prototype ? prototype : hasLine ? nodeMeant(each, scan, vrml2) : firstMeant(each, scan);
    if (!text) continue;
    if (!hasLine || prototype) each.line = text->line;  // of a declaration Coin says where it ends
    if (each.node.empty()) each.node = text->keyword + (text->name.empty() ? "" : " \"" + text->name + "\"");
  }
  return said;
}

}  // namespace haptiv
