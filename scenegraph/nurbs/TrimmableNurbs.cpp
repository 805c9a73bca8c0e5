#include "scenegraph/nurbs/TrimmableNurbs.h"

#include <Inventor/SbBox3f.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoNurbsSurface.h>

#include "scenegraph/ReplaceNode.h"

namespace haptiv {
namespace {

template <typename Node>
class Trimmable final : public Node, public TrimmableNurbs {
 public:
  void GLRender(SoGLRenderAction* action) override {
    if (TrimmedPlace::of(this, action->getState())) {
      SoShape::GLRender(action);  // by its triangles
    } else {
      Node::GLRender(action);
    }
  }

  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override {
    Node::copyContents(from, copyConnections);
    if (const auto* other = dynamic_cast<const TrimmableNurbs*>(from)) cuts = other->cuts;
  }

 protected:
  void generatePrimitives(SoAction* action) override {
    const auto place = TrimmedPlace::of(this, action->getState());
    if (!place) return Node::generatePrimitives(action);
    if (!cuts) return;
    SoPrimitiveVertex vertex;
    this->beginShape(action, SoShape::TRIANGLES, nullptr);
    for (const CutCorner& corner : cuts->at(*place)) {
      vertex.setPoint(corner.point);
      vertex.setNormal(corner.normal);
      vertex.setTextureCoords(corner.texture);
      this->shapeVertex(&vertex);
    }
    this->endShape();
  }

  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& center) override {
    const auto place = TrimmedPlace::of(this, action->getState());
    if (!place) return Node::computeBBox(action, box, center);
    box.makeEmpty();
    if (!cuts) return;
    for (const CutCorner& corner : cuts->at(*place)) box.extendBy(corner.point);
    if (!box.isEmpty()) center = box.getCenter();
  }
};

}  // namespace

void makeNurbsTrimmable() {
  replaceNode<SoNurbsSurface, Trimmable<SoNurbsSurface>>();
  replaceNode<SoIndexedNurbsSurface, Trimmable<SoIndexedNurbsSurface>>();
}

}  // namespace haptiv
