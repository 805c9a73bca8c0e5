#include "scenegraph/solid/SolidModel.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoSphere.h>

#include <algorithm>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/NumberText.h"

namespace haptiv {
namespace {

// Of models [m]: beyond these, masses and stiffnesses that fit them leave what a scene's numbers hold well.
constexpr float kSmallest = 1e-12F;
constexpr float kLargest = 1e12F;

std::vector<SoSFFloat*> sizesOf(SoNode* node) {
  if (auto* cube = dynamic_cast<SoCube*>(node)) return {&cube->width, &cube->height, &cube->depth};
  if (auto* sphere = dynamic_cast<SoSphere*>(node)) return {&sphere->radius};
  if (auto* cylinder = dynamic_cast<SoCylinder*>(node)) return {&cylinder->radius, &cylinder->height};
  if (auto* cone = dynamic_cast<SoCone*>(node)) return {&cone->bottomRadius, &cone->height};
  return {};
}

}  // namespace

SbBox3f modelBounds(SoNode* root) {
  SoGetBoundingBoxAction bounds(SbViewportRegion(640, 480));
  bounds.apply(root);
  return bounds.getBoundingBox();
}

std::string solidFault(const SbBox3f& model) {
  if (model.isEmpty()) return "it shows no shape: give it one, or show what a Switch hides";
  const SbVec3f size = model.getMax() - model.getMin();
  const float largest = std::max({size[0], size[1], size[2]});
  if (largest >= kSmallest && largest <= kLargest) return {};  // not where it is no number
  return "it is " + numberText(largest) + " m in size: correct its points and transforms to between " +
         numberText(kSmallest) + " and " + numberText(kLargest) + " m";
}

std::vector<NegativeSize> negativeSizes(SoNode* root) {
  std::vector<NegativeSize> found;
  for (SoNode* node : writtenNodes(root)) {
    for (SoSFFloat* field : sizesOf(node)) {
      if (field->getValue() < 0) found.push_back({node, field});
    }
  }
  return found;
}

}  // namespace haptiv
