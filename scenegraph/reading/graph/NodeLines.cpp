#include "scenegraph/reading/graph/NodeLines.h"

#include <Inventor/SbName.h>
#include <Inventor/fields/SoMFNode.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSeparator.h>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"

namespace haptiv {
namespace {

using Texts = std::vector<const TextNode*>;

/// Goes through text and graph side by side.
class Alignment {
 public:
  Alignment(const SceneScan& scan, bool vrml2) : vrml2_(vrml2), first_(scan.nodes.data()), below_(scan.nodes.size()) {
    for (const TextNode& text : scan.nodes) {
      if (!text.isApart) (text.parent == TextNode::kNone ? top_ : below_[text.parent]).push_back(&text);
    }
  }

  NodeLines run(SoSeparator* root) {
    if (top_.empty()) return {};
    lines_[root] = top_.front()->line;
    if (top_.size() == 1 && isOf(*top_.front(), root)) {  // of a single Separator Coin makes the root
      waiting_.push_back({top_.front(), root});
    } else {
      alignChildren(top_, *root);
    }
    while (!waiting_.empty()) {
      const auto [text, node] = waiting_.back();
      waiting_.pop_back();
      alignBelow(below_[static_cast<std::size_t>(text - first_)], node);
    }
    return std::move(lines_);
  }

 private:
  struct Pair {
    const TextNode* text;
    SoNode* node;
  };

  bool isOf(const TextNode& text, const SoNode* node) const {
    const SoType type = typeOfKeyword(text.keyword, vrml2_);
    static const SoType kUnknown = SoType::fromName("UnknownNode");  // Coin has no header for it
    return type == node->getTypeId() || (type.isBad() && node->getTypeId() == kUnknown);
  }

  void align(const TextNode& text, SoNode* node) {
    if (text.keyword.empty() || !node) return;  // where it is used: it has the line where it is defined
    lines_[node] = text.line;
    if (isOf(text, node)) waiting_.push_back({&text, node});
  }

  void alignBelow(const Texts& texts, SoNode* node) {
    Texts children;
    std::unordered_map<SoMFNode*, Texts> lists;
    for (const TextNode* text : texts) {
      SoField* field = node->getField(SbName(std::string(text->field).c_str()));
      if (auto* one = dynamic_cast<SoSFNode*>(field)) {
        align(*text, one->getValue());
      } else if (node->isOfType(SoGroup::getClassTypeId())) {
        children.push_back(text);
      } else if (auto* many = dynamic_cast<SoMFNode*>(field)) {
        lists[many].push_back(text);
      }
    }
    for (const auto& [list, inIt] : lists) {
      for (int i = 0; list->getNum() == static_cast<int>(inIt.size()) && i < list->getNum(); ++i)
        align(*inIt[static_cast<std::size_t>(i)], (*list)[i]);
    }
    if (!children.empty()) alignChildren(children, *node);
  }

  void alignChildren(const Texts& texts, const SoNode& group) {
    const std::vector<SoNode*> children = writtenChildren(&group);
    if (children.size() != texts.size()) return;
    for (std::size_t i = 0; i < children.size(); ++i) align(*texts[i], children[i]);
  }

  const bool vrml2_;
  const TextNode* const first_;
  Texts top_;
  std::vector<Texts> below_;
  std::vector<Pair> waiting_;
  NodeLines lines_;
};

/// What has none has that of the node that it is part of. `root` is part of nothing, and may be more than is written.
void addPartsOf(SoNode* root, NodeLines& lines) {
  for (SoNode* node : writtenNodes(root)) {
    const auto line = lines.find(node);
    if (line == lines.end() || node == root) continue;
    const int own = line->second;
    for (SoNode* part : writtenChildren(node)) lines.try_emplace(part, own);
  }
}

}  // namespace

NodeLines findLines(const SceneScan& scan, SoSeparator* root, bool vrml2) {
  NodeLines lines = Alignment(scan, vrml2).run(root);
  addPartsOf(root, lines);
  return lines;
}

}  // namespace haptiv
