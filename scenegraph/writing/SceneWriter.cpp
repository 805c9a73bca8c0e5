#include "scenegraph/writing/SceneWriter.h"

#include <Inventor/fields/SoField.h>
#include <Inventor/misc/SoProto.h>
#include <Inventor/misc/SoProtoInstance.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "scenegraph/CoinMessages.h"
#include "scenegraph/GraphText.h"
#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"

namespace haptiv {
namespace {

/// Whether a field holds floating-point numbers, of which "nan" and "inf" cannot be read back.
bool holdsFloats(const SoField& field) {
  static constexpr std::array<std::string_view, 9> kKinds = {"Float", "Double", "Vec2",  "Vec3",    "Vec4",
                                                             "Color", "Matrix", "Plane", "Rotation"};
  const std::string_view type = field.getTypeId().getName().getString();
  for (const std::string_view kind : kKinds) {
    if (type.find(kind) != std::string_view::npos) return true;
  }
  return type.find("Time") != std::string_view::npos;
}

void checkNumbers(const SoNode* node) {
  for (SoField* field : fieldsOf(node)) {
    if (field->isDefault() || !holdsFloats(*field)) continue;
    SbString text;
    field->get(text);
    if (std::string_view(text.getString()).find('n') == std::string_view::npos) continue;  // of nan, inf
    SbName name;
    node->getFieldName(field, name);
    throw std::runtime_error(describe(node) + ": " + name.getString() +
                             " holds a number that is not finite, which a scene file cannot hold: correct it first");
  }
}

}  // namespace

const SoNode* findPrototype(SoNode* root) {
  const std::vector<SoNode*> nodes = writtenNodes(root);
  const auto found = std::ranges::find_if(nodes, [](SoNode* node) {
    return node->isOfType(SoProto::getClassTypeId()) || SoProtoInstance::findProtoInstance(node);
  });
  return found == nodes.end() ? nullptr : *found;
}

std::string writeSceneText(SoNode* root) {
  const CoinMessages silence{std::string()};  // of prototypes within each other Coin counts wrongly, and writes well
  for (const SoNode* node : writtenNodes(root)) checkNumbers(node);
  static constexpr int kDigits = 8;
  return graphText(root, kDigits, findPrototype(root) ? "#VRML V2.0 utf8" : "#Inventor V2.1 ascii");
}

}  // namespace haptiv
