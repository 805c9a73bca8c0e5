#include "scenegraph/reading/SceneReader.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>

#include <algorithm>

#include "scenegraph/CoinMessages.h"
#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"
#include "scenegraph/isolation/Isolated.h"
#include "scenegraph/nurbs/CutTrimmedNurbs.h"
#include "scenegraph/reading/ExternalPrototypes.h"
#include "scenegraph/reading/coin/Rehearsal.h"
#include "scenegraph/reading/files/NamedFiles.h"
#include "scenegraph/reading/files/SceneBytes.h"
#include "scenegraph/reading/files/ScenePath.h"
#include "scenegraph/reading/graph/GraphExpansion.h"
#include "scenegraph/reading/graph/NodeLines.h"
#include "scenegraph/reading/graph/NurbsSwitch.h"
#include "scenegraph/reading/graph/ShapeIndices.h"
#include "scenegraph/reading/text/Header.h"
#include "scenegraph/reading/text/NodeAtLine.h"
#include "scenegraph/reading/text/SceneScan.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;
using Severity = Diagnostic::Severity;

constexpr std::size_t kMostNestedFiles = 16;  // files within files
constexpr std::size_t kMaxIncluded = 1000;    // files

void say(SceneFile& scene, Severity severity, std::string message, int line = 0) {
  scene.diagnostics.push_back({severity, scene.path, line, {}, std::move(message), nullptr});
}

void fail(SceneFile& scene, std::string message, int line = 0) {
  say(scene, Severity::error, std::move(message), line);
}

/// On which line of the text this stands; 0 where it stands nowhere, or more than once.
int lineOfOnly(const std::string& what, const std::string& text) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos || text.find(what, at + 1) != std::string::npos) return 0;
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Says where the nodes that diagnostics name stand.
void addLocated(SceneFile& scene, Diagnostics found) {
  for (Diagnostic& diagnostic : found) {
    locate(diagnostic, scene);
    scene.diagnostics.push_back(std::move(diagnostic));
  }
}

}  // namespace

SceneFile SceneReader::read(std::string bytes, const std::string& name) {
  SceneFile scene;
  scene.path = name;
  scene.text = std::move(bytes);
  std::error_code ignored;
  paths_.push_back(fs::weakly_canonical(name, ignored));
  readGraph(scene);
  if (scene.root) judge(scene);
  if (hasErrors(scene.diagnostics)) {
    scene.root = {};
    scene.lineOf.clear();
    scene.fileOf.clear();
    for (Diagnostic& diagnostic : scene.diagnostics) diagnostic.source = nullptr;  // the graph is not handed out
  }
  return scene;
}

void SceneReader::readGraph(SceneFile& scene) {
  bytes_ += scene.text.size();
  if (bytes_ > kMaxSceneBytes)
    return fail(scene, "the scene with all that it includes is larger than 256 MB: split it");
  const std::string header = headerFault(scene.text);
  if (!header.empty()) return fail(scene, header, 1);
  reading_.push_back(&scene);
  parse(scene);
  reading_.pop_back();
}

void SceneReader::parse(SceneFile& scene) {
  const ExternalPrototypes prototypes(*this);
  const bool isBinary = isBinaryHeader(scene.text);
  if (isBinary) {
    Isolated converted = convertBinary(scene.text);
    if (!converted.fault.empty()) return fail(scene, converted.fault);
    scene.text = std::move(converted.result);
  }
  const bool vrml2 = scene.text.starts_with("#VRML V2");
  const SceneScan scan = scanSceneText(scene.text, scene.path);
  const auto add = [&](const Diagnostics& said) {
    for (Diagnostic each : said) {
      if (isBinary) each.line = 0;  // its user has not seen this text
      scene.diagnostics.push_back(std::move(each));
    }
  };
  add(scan.diagnostics);
  if (hasErrors(scene.diagnostics)) return;
  if (!scan.isPlain) {
    const Isolated rehearsal = rehearse(scene.text);
    if (!rehearsal.fault.empty())
      return add(located({{Severity::error, scene.path, rehearsal.line, {}, rehearsal.fault, nullptr}}, scan, vrml2));
  }
  const CoinMessages messages(scene.path);
  SoInput input;
  input.setBuffer(scene.text.data(), scene.text.size());
  scene.root = NodeRef<SoSeparator>(SoDB::readAll(&input));
  add(located(scene.root ? messages.ofReadScene() : messages.diagnostics(), scan, vrml2));
  if (!scene.root && !hasErrors(scene.diagnostics))
    fail(scene, "Coin cannot read it: check it for wrong words or brackets");
  if (!scene.root) return;
  if (!isBinary) scene.lineOf = findLines(scan, scene.root.get(), vrml2);
  open(scene);
}

void SceneReader::open(SceneFile& scene) {
  const fs::path folder = fs::path(scene.path).parent_path();
  const ReadScene readIncluded = [&](const fs::path& path, const SoNode* namedBy) {
    return include(scene, path, namedBy);
  };
  addLocated(scene, loadNamedFiles(scene.root.get(), {folder, home_}, readIncluded, pictures_));
}

NodeRef<SoSeparator> SceneReader::include(SceneFile& scene, const fs::path& path, const SoNode* namedBy) {
  const auto refuse = [&](const std::string& why) {
    addLocated(scene,
               {{Severity::error, {}, 0, describe(namedBy), "\"" + path.filename().string() + "\" " + why, namedBy}});
    return NodeRef<SoSeparator>();
  };
  if (std::ranges::find(paths_, path) != paths_.end()) return refuse("includes itself: remove the node");
  if (const auto known = included_.find(path); known != included_.end()) return known->second;
  if (paths_.size() > kMostNestedFiles) return refuse("is included over more than 16 files: include it directly");
  if (included_.size() >= kMaxIncluded) return refuse("is one file too many: a scene includes 1000 at most");
  SceneBytes contents = readSceneBytes(path);
  if (!contents.fault.empty()) return refuse(contents.fault);

  SceneFile part;
  part.path = (fs::path(scene.path).parent_path() /
               fs::relative(path, fs::weakly_canonical(fs::path(scene.path)).parent_path()))
                  .string();
  part.text = std::move(contents.bytes);
  paths_.push_back(path);
  readGraph(part);
  paths_.pop_back();
  scene.diagnostics.insert(scene.diagnostics.end(), part.diagnostics.begin(), part.diagnostics.end());
  scene.fileOf.insert(part.fileOf.begin(), part.fileOf.end());
  for (const auto& [node, line] : part.lineOf) {
    scene.lineOf[node] = line;
    scene.fileOf.emplace(node, part.path);
  }
  included_[path] = part.root;
  return part.root;
}

void SceneReader::judge(SceneFile& scene) {
  const auto tellLeftOut = [&scene](const std::vector<const SoNode*>& shapes, const std::string& why) {
    Diagnostics left;
    for (const SoNode* shape : shapes)
      left.push_back({Severity::warning, {}, 0, describe(shape), "is neither shown nor felt" + why, shape});
    addLocated(scene, std::move(left));
  };
  tellLeftOut(switchOffEmptyNurbs(scene.root.get()), ", for it has no control points: give it some, or remove it");
  const auto [why, node] = expansionFault(scene.root.get());
  if (!why.empty()) return addLocated(scene, {{Severity::error, {}, 0, describe(node), why, node}});
  addLocated(scene, shapeIndexFaults(scene.root.get()));
  if (hasErrors(scene.diagnostics)) return;
  tellLeftOut(
      cutTrimmedNurbs(scene.root.get()),
      " where profiles trim it, for in its time GLU cuts no triangles of it: correct its profiles, or convert it "
      "to triangles");
}

std::string SceneReader::prototypeText(const std::string& url) {
  SceneFile& scene = *reading_.back();
  const NamedFile file = judgeName(url, fs::path(scene.path).parent_path(), home_);
  const auto refuse = [&](const std::string& why) {
    const int line = lineOfOnly("\"" + url + "\"", scene.text);
    scene.diagnostics.push_back({Severity::error, scene.path, line, "EXTERNPROTO", why, nullptr});
    return std::string();
  };
  if (file.verdict == NamedFile::Verdict::forbidden) return refuse(file.why);
  if (file.verdict != NamedFile::Verdict::inside) return {};
  SceneBytes contents;
  {
    const FilesAllowed here;
    contents = readSceneBytes(file.path);
  }
  bytes_ += contents.bytes.size();
  if (!contents.fault.empty()) return refuse("\"" + url + "\" " + contents.fault);
  if (bytes_ > kMaxSceneBytes) return refuse("\"" + url + "\" makes the scene too large");
  const std::string header = headerFault(contents.bytes);
  const SceneScan scan = scanSceneText(contents.bytes, file.path.filename().string());
  scene.diagnostics.insert(scene.diagnostics.end(), scan.diagnostics.begin(), scan.diagnostics.end());
  if (!header.empty()) return refuse("\"" + url + "\": " + header);
  return hasErrors(scan.diagnostics) ? std::string() : contents.bytes;
}

}  // namespace haptiv
