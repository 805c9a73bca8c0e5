#include "app/editor/document/Selection.h"

#include <Inventor/SoPath.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/lists/SoPathList.h>

#include <algorithm>

namespace haptiv {
namespace {

int sharedLength(const SoPath& a, const SoPath& b) {
  const int length = std::min(a.getLength(), b.getLength());
  int shared = 0;
  while (shared < length && a.getNode(shared) == b.getNode(shared)) ++shared;
  return shared;
}

}  // namespace

void Selection::set(const SoPath* path) {
  path_ = path ? NodeRef<SoPath>(path->copy()) : NodeRef<SoPath>();
  node_ = path ? NodeRef<SoNode>(path->getTail()) : NodeRef<SoNode>();
}

bool Selection::isIntact(SoSeparator* root) const {
  return path_ && path_->getHead() == root && path_->getTail() == node_.get();
}

const SoPath* Selection::resolve(SoSeparator* root) {
  if (!node_) return nullptr;
  if (isIntact(root)) return path_.get();

  SoSearchAction search;
  search.setNode(node_.get());
  search.setInterest(SoSearchAction::ALL);
  search.setSearchingAll(TRUE);
  search.apply(root);
  const SoPathList& found = search.getPaths();
  const SoPath* best = nullptr;
  for (int i = 0; i < found.getLength(); ++i) {
    const SoPath* candidate = found[i];
    if (!best || sharedLength(*candidate, *path_.get()) > sharedLength(*best, *path_.get())) best = candidate;
  }
  if (!best) return nullptr;
  path_ = NodeRef<SoPath>(best->copy());
  return path_.get();
}

}  // namespace haptiv
