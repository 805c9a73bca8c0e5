#include "scenegraph/reading/text/SceneScan.h"

#include <Inventor/SbName.h>

#include <algorithm>
#include <optional>

#include "scenegraph/reading/text/DeclaredFields.h"
#include "scenegraph/reading/text/ImageSize.h"
#include "scenegraph/reading/text/NodeNames.h"
#include "scenegraph/reading/text/PlainNodes.h"
#include "scenegraph/reading/text/Prototypes.h"
#include "scenegraph/reading/text/SceneTokenizer.h"

namespace haptiv {
namespace {

using Kind = SceneToken::Kind;

constexpr std::size_t kDeepestText = 1000;   // Coin reads recursively; its stack ends near 11,600
constexpr std::size_t kMaxDiagnostics = 50;  // a broken file need not be quoted in full
constexpr std::size_t kNoNode = TextNode::kNone;

/// One pass over the tokens; `levels_` holds the brackets that are open.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& file)
      : tokens_(text), file_(file), vrml2_(text.starts_with("#VRML V2")), image_(text.size()) {}

  SceneScan run() {
    while (scan_.diagnostics.size() < kMaxDiagnostics) {
      const SceneToken token = tokens_.next();
      if (token.kind == Kind::end) break;
      if (token.kind == Kind::bad) {
        fail(token.line, keyword(), std::string(token.text));
        return std::move(scan_);
      }
      if (token.kind == Kind::unclear) {  // the rest is for the rehearsal
        scan_.isPlain = false;
        return std::move(scan_);
      }
      if (levels_.empty() && endsScene(token)) {
        takeEnd(token);
        return std::move(scan_);
      }
      take(token);
      if (levels_.size() > kDeepestText) {
        fail(token.line, {}, "nested deeper than 1000 levels: make the scene flatter");
        return std::move(scan_);
      }
    }
    finish();
    return std::move(scan_);
  }

 private:
  struct Level {
    Kind kind = Kind::open;
    int line = 0;
    std::size_t node = kNoNode;  ///< index into scan_.nodes
    bool isBody = false;         ///< of a prototype
    bool isApart = false;        ///< what stands in it is no part of the scene where it stands
    std::string_view field;      ///< the word before a list
  };

  void take(const SceneToken& token) {
    switch (token.kind) {
      case Kind::word:
        takeWord(token);
        break;
      case Kind::string:
        takeValue(token);
        break;
      case Kind::open:
      case Kind::openList:
        open(token);
        break;
      case Kind::close:
      case Kind::closeList:
        close(token);
        break;
      default:
        break;
    }
  }

  void takeWord(const SceneToken& token) {
    const std::string_view word = token.text;
    if (!names_.expectsWord() && prototypes_.takesWord(word)) {
      takePrototype(token);
    } else if (names_.takes(word)) {
      if (names_.isUse()) addUse(token);
      if (word == "ROUTE") scan_.isPlain = false;
    } else {
      takePlainWord(token);
    }
  }

  /// PROTO or EXTERNPROTO, and then its name.
  void takePrototype(const SceneToken& token) {
    scan_.isPlain = false;
    word_.reset();
    if (prototypes_.isNamed()) {
      scan_.nodes.back().name = token.text;
    } else {
      scan_.nodes.push_back({std::string(token.text), {}, token.line, token.line, enclosing(), {}, isApart()});
    }
  }

  void takePlainWord(const SceneToken& token) {
    before_ = word_ ? word_->text : std::string_view();
    takeValue(token);
    word_ = token;
    if (image_.isTooLarge(token.text))
      fail(token.line, keyword(), "the image is said to be larger than the whole file: correct its size");
    if (token.text.find('=') != std::string_view::npos) scan_.isPlain = false;
  }

  /// A string, or a word that may be an unquoted one.
  void takeValue(const SceneToken& token) {
    if (declaring_) declared_.push_back(std::string(token.text));
    if (token.kind == Kind::string) {
      word_.reset();
      prototypes_.takeString(levels_.size());
    }
  }

  void open(const SceneToken& token) {
    Level level{token.kind, token.line, kNoNode, false, prototypes_.isOpen() || isApart(), {}};
    if (token.kind == Kind::open) {
      level.isBody = prototypes_.opensBody(levels_.size());
      if (word_ && !level.isBody) {
        level.node = addNode(*word_);
        level.isApart = scan_.nodes[level.node].isApart;
      }
    } else {
      if (word_) level.field = word_->text;
      prototypes_.openList(levels_.size());
      declaring_ = word_ && (word_->text == "fields" || word_->text == "inputs") && !keyword().empty();
      declared_.clear();
    }
    word_.reset();
    levels_.push_back(level);
  }

  std::size_t addNode(const SceneToken& keyword) {
    const std::size_t index = scan_.nodes.size();
    const std::string_view field = fieldBefore(before_);
    const bool apart = isApart() || field.ends_with('=');
    scan_.nodes.push_back(
        {std::string(keyword.text), names_.begin(index), keyword.line, keyword.line, enclosing(), field, apart});
    if (!isPlainNode(keyword.text) || names_.areVeryMany()) scan_.isPlain = false;
    const std::string fault = prototypes_.add(keyword.text);
    if (!fault.empty()) fail(keyword.line, std::string(keyword.text), fault);
    return index;
  }

  void close(const SceneToken& token) {
    word_.reset();
    if (levels_.empty()) return fail(token.line, {}, "\"" + std::string(token.text) + "\" closes nothing: remove it");
    const Kind opener = token.kind == Kind::close ? Kind::open : Kind::openList;
    if (levels_.back().kind != opener) {
      fail(token.line, {},
           "\"" + std::string(token.text) + "\" does not close the bracket of line " +
               std::to_string(levels_.back().line) + ": check the brackets between them");
    }
    if (levels_.back().isBody) prototypes_.closeBody();
    if (levels_.back().node != kNoNode) scan_.nodes[levels_.back().node].lastLine = token.line;
    levels_.pop_back();
    if (declaring_) checkDeclared(token.line);
    declaring_ = false;
  }

  void checkDeclared(int line) {
    const std::string fault = declaredFieldsFault(keyword(), vrml2_, declared_);
    if (!fault.empty()) fail(line, keyword(), fault);
  }

  void addUse(const SceneToken& token) {
    const std::string_view field = fieldBefore(word_ ? word_->text : std::string_view());
    scan_.nodes.push_back({{}, {}, token.line, token.line, enclosing(), field, isApart() || field.ends_with('=')});
    if (names_.used()) checkUse(token, *names_.used());
  }

  void checkUse(const SceneToken& token, std::size_t node) {
    if (word_ && word_->text.ends_with('=')) return;  // a field's connection, which Blinker has to itself
    const auto isIt = [&](const Level& level) { return level.node == node; };
    if (!keyword().ends_with("Script") && std::ranges::any_of(levels_, isIt)) {  // a Script only refers to it
      fail(token.line, std::string(token.text), "stands inside itself (USE within its own DEF): remove this USE");
    }
  }

  /// Between nodes, Coin takes whatever cannot begin one for the end.
  bool endsScene(const SceneToken& token) const {
    if (names_.expectsWord() || prototypes_.isOpen()) return false;
    if (word_) return token.kind != Kind::open;
    return token.kind != Kind::word || !SbName::isIdentStartChar(token.text.front());
  }

  void takeEnd(const SceneToken& token) {
    const SceneToken& first = word_ ? *word_ : token;
    const std::string culprit = "\"" + std::string(first.text.substr(0, 60)) + "\"";
    if (word_ || scan_.nodes.empty())
      return fail(first.line, {}, culprit + " is no node: a scene is made of Keyword { ... }");
    const bool isLost = token.kind == Kind::open || tokens_.rest().find('{') != std::string_view::npos;
    const bool isBracket = token.kind == Kind::close || token.kind == Kind::closeList;
    fail(token.line, {},
         culprit + (isBracket ? " closes nothing" : " is no node") +
             (isLost ? ", and the nodes after it would not be read: remove it, or open the bracket before"
                     : ", and nothing after it is read: remove it"));
    if (!isLost) scan_.diagnostics.back().severity = Diagnostic::Severity::warning;
  }

  void finish() {
    if (!levels_.empty()) {
      fail(levels_.back().line, keyword(), "the bracket that opens here is never closed: is the file cut off?");
    } else if (word_) {
      fail(word_->line, {},
           "\"" + std::string(word_->text.substr(0, 60)) + "\" is no node: a scene is made of Keyword { ... }");
    }
  }

  /// The node that the scanner is in.
  std::size_t enclosing() const {
    const auto level = std::find_if(levels_.rbegin(), levels_.rend(), [](const Level& l) { return l.node != kNoNode; });
    return level == levels_.rend() ? kNoNode : level->node;
  }

  /// Its keyword; empty at the top.
  std::string keyword() const { return enclosing() == kNoNode ? std::string() : scan_.nodes[enclosing()].keyword; }

  bool isApart() const { return !levels_.empty() && levels_.back().isApart; }

  /// Which field a node stands in, by the word before it: in a list, that of the list.
  std::string_view fieldBefore(std::string_view word) const {
    const bool isInList = !levels_.empty() && levels_.back().kind == Kind::openList;
    return isInList ? levels_.back().field : word;
  }

  void fail(int line, const std::string& node, const std::string& message) {
    scan_.diagnostics.push_back({Diagnostic::Severity::error, file_, line, node, message, nullptr});
  }

  SceneTokenizer tokens_;
  const std::string& file_;
  const bool vrml2_;
  SceneScan scan_;
  std::vector<Level> levels_;
  std::optional<SceneToken> word_;  ///< the word just before, which may turn out to be a keyword
  std::string_view before_;         ///< and the one before that
  NodeNames names_;
  bool declaring_ = false;  ///< in `fields [ ... ]`
  std::vector<std::string> declared_;
  ImageSize image_;
  Prototypes prototypes_;
};

}  // namespace

SceneScan scanSceneText(std::string_view text, const std::string& file) {
  return Scanner(text, file).run();
}

}  // namespace haptiv
