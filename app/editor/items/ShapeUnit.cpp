#include "app/editor/items/ShapeUnit.h"

#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoCamera.h>
#include <Inventor/nodes/SoLight.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoTransform.h>

#include "app/editor/items/SceneItems.h"

namespace haptiv {
namespace {

bool holdsShape(SoNode* node) {
  if (node->isOfType(SoTransform::getClassTypeId())) return false;  // the shapes of a manip are none of the scene
  SoSearchAction search;
  search.setType(SoShape::getClassTypeId());
  search.setSearchingAll(TRUE);
  search.apply(node);
  return search.getPath() != nullptr;
}

bool isProperty(const SoNode& node) {
  const QString word = keyword(node);
  return word != "HapticTool" && word != "HapticDevice" && !node.isOfType(SoGroup::getClassTypeId()) &&
         !node.isOfType(SoCamera::getClassTypeId()) && !node.isOfType(SoLight::getClassTypeId());
}

}  // namespace

bool standsAlone(const SoPath& path) {
  if (path.getLength() < 2) return false;
  SoNode* parent = path.getNodeFromTail(1);
  if (!parent->isOfType(SoSeparator::getClassTypeId())) return false;
  auto* group = static_cast<SoGroup*>(parent);
  for (int i = 0; i < group->getNumChildren(); ++i) {
    if (i != path.getIndexFromTail(0) && holdsShape(group->getChild(i))) return false;
  }
  return true;
}

int depthOfUnit(const SoPath& path) {
  if (path.getLength() < 3 || !standsAlone(path)) return 0;
  auto* group = static_cast<SoGroup*>(path.getNodeFromTail(1));
  for (int i = 0; i < group->getNumChildren(); ++i) {
    if (i != path.getIndexFromTail(0) && !isProperty(*group->getChild(i))) return 0;
  }
  return 1;
}

}  // namespace haptiv
