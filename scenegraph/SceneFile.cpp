#include "scenegraph/SceneFile.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoInteraction.h>
#include <Inventor/lists/SbStringList.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "scenegraph/Keyword.h"
#include "scenegraph/nodes/HapticNodes.h"
#include "scenegraph/reading/CoinMessages.h"
#include "scenegraph/reading/GraphWalk.h"
#include "scenegraph/reading/RefusedText.h"
#include "scenegraph/reading/SceneScan.h"
#include "scenegraph/reading/ShapeIndices.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxBytes = 256u << 20;  // some four million triangles as text

/// Coin looks for a scene's textures in its folder, and nowhere else, while this lives.
class TextureFolder {
 public:
  explicit TextureFolder(const fs::path& folder) {
    const SbStringList& list = SoInput::getDirectories();
    for (int i = 0; i < list.getLength(); ++i) before_.emplace_back(list[i]->getString());
    SoInput::clearDirectories();
    SoInput::addDirectoryFirst(folder.empty() ? "." : folder.c_str());
  }
  ~TextureFolder() {
    SoInput::clearDirectories();
    for (const std::string& directory : before_) SoInput::addDirectoryLast(directory.c_str());
  }
  TextureFolder(const TextureFolder&) = delete;
  TextureFolder& operator=(const TextureFolder&) = delete;

 private:
  std::vector<std::string> before_;
};

void fail(SceneFile& scene, std::string message) {
  scene.diagnostics.push_back({Diagnostic::Severity::error, scene.path, 0, {}, std::move(message), nullptr});
}

/// Why a path cannot be read as a scene; empty where it can.
std::string fileFault(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return "there is no such file: check its name and folder";
  if (error) return "cannot be looked at: " + error.message();
  if (fs::is_directory(status)) return "is a folder: name a scene file in it";
  if (!fs::is_regular_file(status)) return "is not a regular file: name a scene file";
  if (fs::file_size(path, error) > kMaxBytes) return "is larger than 256 MB: split or simplify it";
  return {};
}

/// Which line each node stands on. Nodes of one type come in the order of the text; where Coin has made more or fewer
/// of a type than stand in the text (parts of node kits), only named ones are told.
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

void readGraph(SceneFile& scene, const fs::path& folder) {
  const CoinMessages messages(scene.path);
  const TextureFolder textures(folder);
  SoInput input;
  input.setBuffer(scene.text.data(), scene.text.size());
  scene.root = NodeRef<SoSeparator>(SoDB::readAll(&input));
  scene.diagnostics.insert(scene.diagnostics.end(), messages.diagnostics().begin(), messages.diagnostics().end());
  if (!scene.root && !hasErrors(scene.diagnostics))
    fail(scene, "Coin cannot read it: check it for wrong words or brackets");
}

void checkGraph(SceneFile& scene) {
  const std::string fault = expansionFault(scene.root.get());
  if (!fault.empty()) return fail(scene, fault);
  Diagnostics bad = shapeIndexFaults(scene.root.get());
  for (Diagnostic& diagnostic : bad) {
    const auto line = scene.lineOf.find(diagnostic.source);
    if (line != scene.lineOf.end()) diagnostic.line = line->second;
    diagnostic.file = scene.path;
    diagnostic.source = nullptr;  // the graph is not handed out
    scene.diagnostics.push_back(std::move(diagnostic));
  }
}

SceneFile readChecked(std::string text, const std::string& name) {
  SceneFile scene;
  scene.path = name;
  scene.text = std::move(text);
  const std::string header = headerFault(scene.text);
  if (!header.empty()) {
    fail(scene, header);
    scene.diagnostics.back().line = 1;
    return scene;
  }
  const fs::path folder = fs::path(name).parent_path();
  const SceneScan scan = scanSceneText(scene.text, name, folder);
  scene.diagnostics = scan.diagnostics;
  if (hasErrors(scene.diagnostics)) return scene;

  readGraph(scene, folder);
  if (scene.root) {
    scene.lineOf = findLines(scan, scene.root.get(), scene.text.starts_with("#VRML V2"));
    checkGraph(scene);
  }
  if (hasErrors(scene.diagnostics)) {
    scene.root = {};
    scene.lineOf.clear();
  }
  return scene;
}

}  // namespace

void initSceneGraph() {
  SoDB::init();
  SoInteraction::init();
  initHapticNodes();
}

SceneFile readScene(const fs::path& path) {
  SceneFile scene;
  scene.path = path.string();
  const std::string fault = fileFault(path);
  if (!fault.empty()) {
    fail(scene, fault);
    return scene;
  }
  std::ifstream in(path, std::ios::binary);
  std::string text;
  if (in) text.assign(std::istreambuf_iterator<char>(in), {});
  if (!in || in.bad()) {
    fail(scene, std::string("cannot be read: ") + std::strerror(errno) + ": check its permissions");
    return scene;
  }
  return readSceneText(text, scene.path);
}

SceneFile readSceneText(std::string_view text, const std::string& name) {
  try {
    return readChecked(std::string(text), name);
  } catch (const std::exception& error) {  // out of memory, mostly
    SceneFile scene;
    scene.path = name;
    fail(scene, std::string("cannot be read: ") + error.what());
    return scene;
  }
}

}  // namespace haptiv
