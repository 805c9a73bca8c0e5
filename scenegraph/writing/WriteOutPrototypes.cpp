#include "scenegraph/writing/WriteOutPrototypes.h"

#include <Inventor/fields/SoField.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/misc/SoProto.h>
#include <Inventor/misc/SoProtoInstance.h>
#include <Inventor/nodes/SoSeparator.h>

#include "scenegraph/GraphWalk.h"

namespace haptiv {
namespace {

/// A field that takes its value from a prototype's (IS) keeps it.
void keepValues(SoNode* node) {
  for (SoField* field : fieldsOf(node)) {
    SoField* source = nullptr;
    if (!field->getConnectedField(source)) continue;
    if (!source->getContainer()->isOfType(SoProtoInstance::getClassTypeId())) continue;
    field->evaluate();
    field->disconnect();
    field->setDefault(FALSE);
  }
}

/// A node that a prototype made is written as that for as long as its SoProtoInstance lives, which the node holds; so
/// may commands that can be undone.
void forgetPrototype(SoNode* node) {
  SoProtoInstance* made = SoProtoInstance::findProtoInstance(node);
  if (!made) return;
  for (int references = made->getRefCount(); references > 0; --references) made->unref();
}

}  // namespace

void writeOutPrototypes(SoSeparator* root) {
  const std::vector<SoNode*> nodes = writtenNodes(root);
  for (SoNode* node : nodes) keepValues(node);
  for (SoNode* node : nodes) {
    forgetPrototype(node);
    SoChildList* children = node->getChildren();
    if (!children) continue;
    for (int i = children->getLength() - 1; i >= 0; --i) {
      if ((*children)[i]->isOfType(SoProto::getClassTypeId())) children->remove(i);
    }
  }
}

}  // namespace haptiv
