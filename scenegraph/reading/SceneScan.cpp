#include "scenegraph/reading/SceneScan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <unordered_map>

#include "scenegraph/reading/DeclaredFields.h"
#include "scenegraph/reading/RefusedText.h"
#include "scenegraph/reading/ScenePath.h"
#include "scenegraph/reading/SceneTokenizer.h"

namespace haptiv {
namespace {

using Kind = SceneToken::Kind;

constexpr std::size_t kMaxDepth = 256;       // Coin reads recursively; its stack ends near 11,600
constexpr std::size_t kMaxDiagnostics = 50;  // a broken file need not be quoted in full
constexpr std::size_t kNoNode = ~std::size_t{0};

/// One pass over the tokens; `levels_` holds the brackets that are open.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& file, const std::filesystem::path& folder)
      : tokens_(text), file_(file), folder_(folder), vrml2_(text.starts_with("#VRML V2")), textSize_(text.size()) {}

  SceneScan run() {
    while (scan_.diagnostics.size() < kMaxDiagnostics) {
      const SceneToken token = tokens_.next();
      if (token.kind == Kind::end) break;
      if (token.kind == Kind::bad) {
        fail(token.line, {}, std::string(token.text));
        return std::move(scan_);
      }
      if (levels_.empty()) checkTopLevel(token);
      take(token);
      if (levels_.size() > kMaxDepth) {
        fail(token.line, {}, "nested deeper than 256 levels: make the scene flatter");
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
  };
  enum class Expect { nothing, defName, useName, route };

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
    if (expect_ == Expect::defName) {
      defName_ = word;
      expect_ = Expect::nothing;
    } else if (expect_ == Expect::useName) {
      checkUse(token);
      expect_ = Expect::nothing;
    } else if (expect_ == Expect::route && --routeWords_ == 0) {
      expect_ = Expect::nothing;
    } else if (expect_ == Expect::nothing) {
      takePlainWord(token);
    }
  }

  void takePlainWord(const SceneToken& token) {
    const std::string_view word = token.text;
    if (word == "DEF") {
      expect_ = Expect::defName;
    } else if (word == "USE") {
      expect_ = Expect::useName;
    } else if (word == "ROUTE" && vrml2_) {
      expect_ = Expect::route;  // ROUTE from TO to
      routeWords_ = 3;
    } else {
      if (word == "PROTO" || word == "EXTERNPROTO") {
        fail(token.line, std::string(word), "prototypes are not read: write out the nodes that they stand for");
      }
      takeValue(token);
      checkImage(token);
      word_ = token;
      if (namesFiles(keyword(), word) && !fileList_) fileField_ = true;
    }
  }

  /// Coin makes room for `image 30000 30000 4` before it looks for the pixels, which take two characters at least.
  void checkImage(const SceneToken& token) {
    if (token.text == "image" || token.text == "images") {
      imageSizes_ = token.text == "image" ? 2 : 3;
      pixels_ = 1;
    } else if (imageSizes_ > 0) {
      --imageSizes_;
      pixels_ *= std::abs(std::atof(std::string(token.text).c_str()));
      if (imageSizes_ == 0 && pixels_ > static_cast<double>(textSize_)) {
        fail(token.line, keyword(), "the image is said to be larger than the whole file: correct its size");
      }
    }
  }

  /// A string, or a word that may be an unquoted one.
  void takeValue(const SceneToken& token) {
    if (declaring_) declared_.push_back(std::string(token.text));
    if (fileField_ || fileList_) {
      const std::string fault = pathFault(token.text, folder_);
      if (!fault.empty()) fail(token.line, keyword(), fault);
      fileField_ = false;
    }
    if (token.kind == Kind::string) word_.reset();
  }

  void open(const SceneToken& token) {
    Level level{token.kind, token.line, kNoNode};
    if (token.kind == Kind::open) {
      if (word_) level.node = addNode(*word_);
    } else if (word_ && (word_->text == "fields" || word_->text == "inputs") && !keyword().empty()) {
      declaring_ = true;
      declared_.clear();
    } else {
      fileList_ = fileField_;
    }
    fileField_ = false;
    word_.reset();
    levels_.push_back(level);
  }

  std::size_t addNode(const SceneToken& keyword) {
    scan_.nodes.push_back({std::string(keyword.text), defName_, keyword.line});
    const std::size_t index = scan_.nodes.size() - 1;
    if (!defName_.empty()) defined_[defName_] = index;
    defName_.clear();
    const std::string why = refusedNode(keyword.text);
    if (!why.empty()) fail(keyword.line, std::string(keyword.text), why);
    return index;
  }

  void close(const SceneToken& token) {
    word_.reset();
    const Kind opener = token.kind == Kind::close ? Kind::open : Kind::openList;
    if (levels_.empty()) return;  // said by checkTopLevel
    if (levels_.back().kind != opener) {
      fail(token.line, {},
           "\"" + std::string(token.text) + "\" does not close the bracket of line " +
               std::to_string(levels_.back().line) + ": check the brackets between them");
    }
    levels_.pop_back();
    if (declaring_) checkDeclared(token.line);
    declaring_ = fileField_ = fileList_ = false;
  }

  void checkDeclared(int line) {
    const std::string fault = declaredFieldsFault(keyword(), vrml2_, declared_);
    if (!fault.empty()) fail(line, keyword(), fault);
  }

  void checkUse(const SceneToken& token) {
    const auto found = defined_.find(std::string(token.text));
    if (found == defined_.end()) return;  // Coin says so
    const auto isIt = [&](const Level& level) { return level.node == found->second; };
    if (std::ranges::any_of(levels_, isIt)) {
      fail(token.line, std::string(token.text), "stands inside itself (USE within its own DEF): remove this USE");
    }
  }

  void checkTopLevel(const SceneToken& token) {
    const bool afterWord = word_.has_value();
    if (token.kind == Kind::open ? afterWord : token.kind == Kind::word && !afterWord) return;
    const std::string_view culprit = afterWord && token.kind == Kind::word ? word_->text : token.text;
    fail(token.line, {},
         token.kind == Kind::close || token.kind == Kind::closeList
             ? "\"" + std::string(culprit) + "\" closes nothing: remove it, or open the bracket before"
             : "\"" + std::string(culprit.substr(0, 60)) + "\" is no node: a scene is made of Keyword { ... }");
    word_.reset();
  }

  void finish() {
    if (!levels_.empty()) {
      fail(levels_.back().line, keyword(), "the bracket that opens here is never closed: is the file cut off?");
    } else if (word_) {
      fail(word_->line, {},
           "\"" + std::string(word_->text.substr(0, 60)) + "\" is no node: a scene is made of Keyword { ... }");
    }
  }

  /// Of the node that the scanner is in; empty at the top.
  std::string keyword() const {
    const auto level = std::find_if(levels_.rbegin(), levels_.rend(), [](const Level& l) { return l.node != kNoNode; });
    return level == levels_.rend() ? std::string() : scan_.nodes[level->node].keyword;
  }

  void fail(int line, const std::string& node, const std::string& message) {
    scan_.diagnostics.push_back({Diagnostic::Severity::error, file_, line, node, message, nullptr});
  }

  SceneTokenizer tokens_;
  const std::string& file_;
  const std::filesystem::path& folder_;
  const bool vrml2_;
  const std::size_t textSize_;
  SceneScan scan_;
  std::vector<Level> levels_;
  std::unordered_map<std::string, std::size_t> defined_;  ///< DEF name to the last node of it
  std::optional<SceneToken> word_;                        ///< the word just before, which may turn out to be a keyword
  std::string defName_;
  Expect expect_ = Expect::nothing;
  int routeWords_ = 0;
  bool declaring_ = false;  ///< in `fields [ ... ]`
  std::vector<std::string> declared_;
  int imageSizes_ = 0;  ///< how many sizes of an image come next
  double pixels_ = 0;
  bool fileField_ = false;  ///< a file name comes next
  bool fileList_ = false;   ///< in a list of file names
};

}  // namespace

SceneScan scanSceneText(std::string_view text, const std::string& file, const std::filesystem::path& folder) {
  return Scanner(text, file, folder).run();
}

}  // namespace haptiv
