#include "scenegraph/Keyword.h"

#include <Inventor/fields/SoSFString.h>
#include <Inventor/nodes/SoNode.h>

namespace haptiv {

SoType typeOfKeyword(const std::string& keyword, bool vrml2) {
  if (vrml2) {
    const SoType type = SoType::fromName(("VRML" + keyword).c_str());
    if (type != SoType::badType()) return type;
  }
  return SoType::fromName(keyword.c_str());
}

std::string describe(const SoNode* node) {
  const std::string keyword = node->getTypeId().getName().getString();
  const auto* label = dynamic_cast<const SoSFString*>(node->getField("label"));
  std::string name = label ? label->getValue().getString() : "";
  if (name.empty()) name = node->getName().getString();
  return name.empty() ? keyword : keyword + " \"" + name + "\"";
}

}  // namespace haptiv
