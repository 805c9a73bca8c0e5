#include "scenegraph/reading/files/NamedFiles.h"

#include <Inventor/VRMLnodes/SoVRMLInline.h>
#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoFile.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoWWWInline.h>

#include "scenegraph/CoinMessages.h"
#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"
#include "scenegraph/reading/files/FontNames.h"
#include "scenegraph/reading/files/NamedFields.h"
#include "scenegraph/reading/files/ScenePath.h"

namespace haptiv {
namespace {

using Severity = Diagnostic::Severity;
using Use = NamedFields::Use;
using Verdict = NamedFile::Verdict;

/// SoFile's default.
bool isUndefined(const std::string& name) {
  return name == "<Undefined file>";
}

/// Coin loads a picture when it learns of its name, and looks in the working directory first: it is told the whole path
/// for as long as that takes.
void letCoinLoad(SoField* field, const std::string& path) {
  SbString before;
  field->get(before);
  field->enableNotify(FALSE);
  if (auto* one = dynamic_cast<SoSFString*>(field)) one->setValue(path.c_str());
  if (auto* many = dynamic_cast<SoMFString*>(field)) many->setValue(path.c_str());
  field->enableNotify(TRUE);
  field->touch();
  field->enableNotify(FALSE);
  field->set(before.getString());
}

/// Why Coin could not load a picture.
std::string pictureFault(const Diagnostics& said) {
  const std::string& message = said.front().message;
  return message.find("simage library") == std::string::npos ? message : "install libsimage20";
}

class Loader {
 public:
  Loader(const NamingFile& from, const ReadScene& readScene, PictureLoader& pictures)
      : from_(from), readScene_(readScene), pictures_(pictures) {}

  Diagnostics diagnostics;

  void load(SoNode* node) {
    const NamedFields named = namedFields(node);
    for (SoField* field : named.fields) {
      const std::vector<std::string> names = takeConnected(node, field);
      if (named.use == Use::scene) loadScene(node, names);
      if (named.use == Use::picture) loadPictures(node, field, names);
      if (named.use == Use::later) keepOrClear(node, field, names);
      if (named.use == Use::font) checkFont(node, field, names);
    }
  }

 private:
  /// What a field names. A name that comes from another field, as in a prototype, becomes the field's own; what an
  /// engine computes, and what will come later, is not followed.
  std::vector<std::string> takeConnected(SoNode* node, SoField* field) {
    if (!field->isConnected()) return stringsOf(field);
    SoField* source = field;
    static constexpr int kMaxSteps = 16;  // fields may be connected in a circle
    for (int i = 0; i < kMaxSteps && source->getConnectedField(source); ++i) {
    }
    const std::vector<std::string> names = stringsOf(source);
    field->disconnect();
    setStrings(field, names);
    if (names.empty())
      say(Severity::warning, node, "a file's name that is computed is not followed: write the name itself");
    return names;
  }

  void loadScene(SoNode* node, const std::vector<std::string>& names) {
    NamedFile last;
    for (const std::string& name : names) {
      if (isUndefined(name)) return;
      last = judgeName(name, from_.folder, from_.home);
      if (last.verdict == Verdict::inside) return attach(node, readScene_(last.path, node));
      if (last.verdict == Verdict::forbidden) break;
    }
    if (!last.why.empty())
      say(last.verdict == Verdict::forbidden ? Severity::error : Severity::warning, node, last.why);
  }

  void attach(SoNode* node, const NodeRef<SoSeparator>& scene) {
    if (!scene) return;
    if (auto* vrml = dynamic_cast<SoVRMLInline*>(node)) return vrml->setChildData(scene.get());
    if (auto* www = dynamic_cast<SoWWWInline*>(node)) return www->setChildData(scene.get());
    for (int i = 0; i < scene->getNumChildren(); ++i) node->getChildren()->append(scene->getChild(i));
  }

  /// Of several names that of the first picture that can be had.
  void loadPictures(SoNode* node, SoField* field, const std::vector<std::string>& names) {
    std::string why;
    for (const std::string& name : names) {
      const NamedFile file = judgeName(name, from_.folder, from_.home);
      why = file.why;
      if (!why.empty()) continue;
      const std::string fault = loadPicture(node, field, file.path);
      if (!fault.empty())
        say(Severity::warning, node, "the texture \"" + name.substr(0, 200) + "\" cannot be shown: " + fault);
      return;
    }
    if (!why.empty()) say(Severity::warning, node, "the texture " + why);
  }

  /// Why the node does not show it; empty where it does.
  std::string loadPicture(SoNode* node, SoField* field, const std::filesystem::path& path) {
    if (pictures_.takes(node)) return pictures_.load(node, path);
    const CoinMessages messages{std::string()};
    letCoinLoad(field, path.string());
    return messages.diagnostics().empty() ? std::string() : pictureFault(messages.diagnostics());
  }

  void keepOrClear(SoNode* node, SoField* field, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const NamedFile file = judgeName(name, from_.folder, from_.home);
      if (file.verdict != Verdict::forbidden) continue;
      setStrings(field, {});
      return say(Severity::warning, node, file.why + "; the name is taken out");
    }
  }

  /// Coin asks the system for fonts by their names, and takes a path for a name.
  void checkFont(SoNode* node, SoField* field, const std::vector<std::string>& names) {
    if (names.empty() || names.front() == "defaultFont") return;
    if (names.front().find('/') == std::string::npos) return checkFontIsThere(node, names.front());
    field->set("defaultFont");
    say(Severity::warning, node,
        "a font's name that is a path is not followed: write the font's name; it is taken out");
  }

  void checkFontIsThere(SoNode* node, const std::string& name) {
    const std::string other = fontInPlaceOf(name);
    if (other.empty()) return;
    say(Severity::warning, node,
        "the font \"" + name.substr(0, 200) + "\" is not on this machine, \"" + other +
            "\" is taken in its place: install it, or write another");
  }

  void say(Severity severity, const SoNode* node, const std::string& message) {
    diagnostics.push_back({severity, {}, 0, describe(node), message, node});
  }

  const NamingFile& from_;
  const ReadScene& readScene_;
  PictureLoader& pictures_;
};

}  // namespace

Diagnostics loadNamedFiles(SoNode* root, const NamingFile& from, const ReadScene& readScene, PictureLoader& pictures) {
  Loader loader(from, readScene, pictures);
  for (SoNode* node : writtenNodes(root)) loader.load(node);
  return std::move(loader.diagnostics);
}

}  // namespace haptiv
