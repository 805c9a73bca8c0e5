#include "scenegraph/reading/ExternalPrototypes.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/misc/SoProto.h>
#include <Inventor/nodes/SoSeparator.h>

#include <string>
#include <utility>

#include "scenegraph/NodeRef.h"
#include "scenegraph/reading/SceneReader.h"

namespace haptiv {
namespace {

constexpr int kMaxNesting = 8;  // a prototype's file may take prototypes from others, and from itself

SceneReader* current = nullptr;  // Coin keeps one callback for all
int nesting = 0;

/// The prototype of this name in a file; the only one, where there is no name.
SoProto* find(SoSeparator* root, const std::string& name) {
  SoSearchAction search;
  search.setType(SoProto::getClassTypeId());
  search.setSearchingAll(TRUE);
  search.setInterest(SoSearchAction::ALL);
  search.apply(root);
  const SoPathList& paths = search.getPaths();
  for (int i = 0; i < paths.getLength(); ++i) {
    auto* proto = static_cast<SoProto*>(paths[i]->getTail());
    if (name == proto->getProtoName().getString() || (name.empty() && paths.getLength() == 1)) return proto;
  }
  return nullptr;
}

SoProto* fetch(SoInput*, const SbString* urls, int count, void*) {
  if (!current || nesting >= kMaxNesting) return nullptr;
  for (int i = 0; i < count; ++i) {
    const std::string url = urls[i].getString();
    const auto hash = url.find('#');
    const std::string text = current->prototypeText(url.substr(0, hash));
    if (text.empty()) continue;
    SoInput input;
    input.setBuffer(text.data(), text.size());
    ++nesting;
    const NodeRef<SoSeparator> root(SoDB::readAll(&input));
    --nesting;
    SoProto* proto =
        root ? find(root.get(), hash == std::string::npos ? std::string() : url.substr(hash + 1)) : nullptr;
    if (!proto) continue;
    proto->ref();  // Coin takes it over, after the file's own graph is gone
    return proto;
  }
  return nullptr;
}

}  // namespace

ExternalPrototypes::ExternalPrototypes(SceneReader& reader) : before_(std::exchange(current, &reader)) {
  SoProto::setFetchExternProtoCallback(&fetch, nullptr);
}

ExternalPrototypes::~ExternalPrototypes() {
  current = before_;
}

}  // namespace haptiv
