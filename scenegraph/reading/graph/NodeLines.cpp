#include "scenegraph/reading/graph/NodeLines.h"

#include <Inventor/SbName.h>
#include <Inventor/nodes/SoNode.h>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"

namespace haptiv {

std::unordered_map<const SoNode*, int> findLines(const SceneScan& scan, SoNode* root, bool vrml2) {
  std::unordered_map<int, std::vector<const TextNode*>> written;
  std::unordered_map<std::string, int> named;
  for (const TextNode& node : scan.nodes) {
    written[typeOfKeyword(node.keyword, vrml2).getKey()].push_back(&node);
    if (!node.name.empty()) named.insert_or_assign(node.name, node.line);
  }
  std::unordered_map<int, std::vector<const SoNode*>> read;
  for (const SoNode* node : writtenNodes(root)) {
    if (node != root) read[node->getTypeId().getKey()].push_back(node);
  }
  std::unordered_map<const SoNode*, int> lines;
  for (const auto& [type, nodes] : read) {
    const auto& texts = written[type];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto name = named.find(nodes[i]->getName().getString());
      if (texts.size() == nodes.size()) {
        lines[nodes[i]] = texts[i]->line;
      } else if (name != named.end()) {
        lines[nodes[i]] = name->second;
      }
    }
  }
  return lines;
}

}  // namespace haptiv
