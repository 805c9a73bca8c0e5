#include "scenegraph/reading/text/SceneScan.h"

#include <optional>

#include "scenegraph/reading/text/DeclaredFields.h"
#include "scenegraph/reading/text/ImageSize.h"
#include "scenegraph/reading/text/NodeNames.h"
#include "scenegraph/reading/text/OpenBrackets.h"
#include "scenegraph/reading/text/PlainNodes.h"
#include "scenegraph/reading/text/Prototypes.h"
#include "scenegraph/reading/text/SceneEnd.h"
#include "scenegraph/reading/text/SceneTokenizer.h"

namespace haptiv {
namespace {

using Kind = SceneToken::Kind;

constexpr std::size_t kDeepestText = 1000;   // Coin reads recursively; its stack ends near 11,600
constexpr std::size_t kMaxDiagnostics = 50;  // a broken file need not be quoted in full

/// One pass over the tokens.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& file)
      : tokens_(text), file_(file), declared_(text.starts_with("#VRML V2")), image_(text.size()) {}

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
      if (isBetweenNodes() && endsScene(token, word_)) {
        report(endOfScene(token, word_, !scan_.nodes.empty(), tokens_.rest()));
        return std::move(scan_);
      }
      take(token);
      if (brackets_.count() > kDeepestText) {
        fail(token.line, {}, "nested deeper than 1000 levels: make the scene flatter");
        return std::move(scan_);
      }
    }
    finish();
    return std::move(scan_);
  }

 private:
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
      scan_.nodes.push_back(
          {std::string(token.text), {}, token.line, token.line, brackets_.node(), {}, brackets_.isApart()});
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
    declared_.take(token.text);
    if (token.kind == Kind::string) {
      word_.reset();
      prototypes_.takeString(brackets_.count());
    }
  }

  void open(const SceneToken& token) {
    OpenBrackets::Bracket bracket{.kind = token.kind, .line = token.line};
    bracket.isApart = prototypes_.isOpen() || brackets_.isApart();
    if (token.kind == Kind::open) {
      bracket.isBody = prototypes_.opensBody(brackets_.count());
      if (word_ && !bracket.isBody) {
        bracket.node = addNode(*word_);
        bracket.isApart = scan_.nodes[bracket.node].isApart;
      }
    } else {
      if (word_) bracket.field = word_->text;
      prototypes_.openList(brackets_.count());
      declared_.openList(word_ ? word_->text : std::string_view(), !keyword().empty());
    }
    word_.reset();
    brackets_.open(bracket);
  }

  std::size_t addNode(const SceneToken& keyword) {
    const std::size_t index = scan_.nodes.size();
    const std::string_view field = brackets_.fieldBefore(before_);
    const bool apart = brackets_.isApart() || field.ends_with('=');
    scan_.nodes.push_back(
        {std::string(keyword.text), names_.begin(index), keyword.line, keyword.line, brackets_.node(), field, apart});
    if (!isPlainNode(keyword.text) || names_.areVeryMany()) scan_.isPlain = false;
    const std::string fault = prototypes_.add(keyword.text);
    if (!fault.empty()) fail(keyword.line, std::string(keyword.text), fault);
    return index;
  }

  void close(const SceneToken& token) {
    word_.reset();
    if (brackets_.empty()) return fail(token.line, {}, "\"" + std::string(token.text) + "\" closes nothing: remove it");
    const Kind opener = token.kind == Kind::close ? Kind::open : Kind::openList;
    if (brackets_.innermost().kind != opener) {
      fail(token.line, {},
           "\"" + std::string(token.text) + "\" does not close the bracket of line " +
               std::to_string(brackets_.innermost().line) + ": check the brackets between them");
    }
    if (brackets_.innermost().isBody) prototypes_.closeBody();
    if (brackets_.innermost().node != TextNode::kNone) scan_.nodes[brackets_.innermost().node].lastLine = token.line;
    brackets_.close();
    const std::string fault = declared_.close(keyword());
    if (!fault.empty()) fail(token.line, keyword(), fault);
  }

  void addUse(const SceneToken& token) {
    const std::string_view field = brackets_.fieldBefore(word_ ? word_->text : std::string_view());
    scan_.nodes.push_back(
        {{}, {}, token.line, token.line, brackets_.node(), field, brackets_.isApart() || field.ends_with('=')});
    if (names_.used()) checkUse(token, *names_.used());
  }

  void checkUse(const SceneToken& token, std::size_t node) {
    if (word_ && word_->text.ends_with('=')) return;  // a field's connection, which Blinker has to itself
    if (!keyword().ends_with("Script") && brackets_.isWithin(node)) {  // a Script only refers to it
      fail(token.line, std::string(token.text), "stands inside itself (USE within its own DEF): remove this USE");
    }
  }

  bool isBetweenNodes() const { return brackets_.empty() && !names_.expectsWord() && !prototypes_.isOpen(); }

  void finish() {
    if (!brackets_.empty()) {
      fail(brackets_.innermost().line, keyword(), "the bracket that opens here is never closed: is the file cut off?");
    } else if (word_) {
      report(wordThatIsNoNode(*word_));
    }
  }

  /// Of the node that the scanner is in; empty at the top.
  std::string keyword() const {
    return brackets_.node() == TextNode::kNone ? std::string() : scan_.nodes[brackets_.node()].keyword;
  }

  void fail(int line, const std::string& node, const std::string& message) {
    report({Diagnostic::Severity::error, {}, line, node, message, nullptr});
  }
  void report(Diagnostic diagnostic) {
    diagnostic.file = file_;
    scan_.diagnostics.push_back(std::move(diagnostic));
  }

  SceneTokenizer tokens_;
  const std::string& file_;
  SceneScan scan_;
  OpenBrackets brackets_;
  std::optional<SceneToken> word_;  ///< the word just before, which may turn out to be a keyword
  std::string_view before_;         ///< and the one before that
  NodeNames names_;
  DeclaredFields declared_;
  ImageSize image_;
  Prototypes prototypes_;
};

}  // namespace

SceneScan scanSceneText(std::string_view text, const std::string& file) {
  return Scanner(text, file).run();
}

}  // namespace haptiv
