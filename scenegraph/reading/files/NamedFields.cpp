#include "scenegraph/reading/files/NamedFields.h"

#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoSFEnum.h>
#include <Inventor/fields/SoSFName.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/nodes/SoNode.h>
#include <Inventor/nodes/SoShaderObject.h>

#include <array>
#include <string_view>

namespace haptiv {
namespace {

using Use = NamedFields::Use;

struct Entry {
  std::string_view type;
  Use use;
  std::vector<const char*> fields;
};

const std::array<Entry, 17>& entries() {
  static const std::array<Entry, 17> kEntries = {{
      {"File", Use::scene, {"name"}},
      {"WWWInline", Use::scene, {"name"}},
      {"VRMLInline", Use::scene, {"url"}},
      {"Texture2", Use::picture, {"filename"}},
      {"Texture3", Use::picture, {"filenames"}},
      {"TextureCubeMap", Use::picture, {"filenames"}},
      {"BumpMap", Use::picture, {"filename"}},
      {"Image", Use::picture, {"filename"}},
      {"VRMLImageTexture", Use::picture, {"url"}},
      {"VRMLMovieTexture", Use::later, {"url"}},
      {"VRMLAudioClip", Use::sound, {"url"}},
      {"VRMLBackground", Use::later, {"backUrl", "bottomUrl", "frontUrl", "leftUrl", "rightUrl", "topUrl"}},
      {"VertexShader", Use::later, {"sourceProgram"}},
      {"FragmentShader", Use::later, {"sourceProgram"}},
      {"GeometryShader", Use::later, {"sourceProgram"}},
      {"Font", Use::font, {"name"}},
      {"FontStyle", Use::font, {"name"}},
  }};
  return kEntries;
}

}  // namespace

NamedFields namedFields(SoNode* node) {
  NamedFields named;
  const std::string_view type = node->getTypeId().getName().getString();
  for (const Entry& entry : entries()) {
    if (entry.type != type) continue;
    named.use = entry.use;
    for (const char* name : entry.fields) {
      if (SoField* field = node->getField(name)) named.fields.push_back(field);
    }
  }
  const auto* shader = dynamic_cast<const SoShaderObject*>(node);
  const bool isText = shader && shader->sourceType.getValue() != SoShaderObject::FILENAME;
  return isText ? NamedFields{} : named;
}

std::vector<std::string> stringsOf(SoField* field) {
  std::vector<std::string> strings;
  if (const auto* one = dynamic_cast<const SoSFString*>(field)) strings.emplace_back(one->getValue().getString());
  if (const auto* name = dynamic_cast<const SoSFName*>(field)) strings.emplace_back(name->getValue().getString());
  if (const auto* many = dynamic_cast<const SoMFString*>(field)) {
    for (int i = 0; i < many->getNum(); ++i) strings.emplace_back((*many)[i].getString());
  }
  std::erase(strings, "");
  return strings;
}

void setStrings(SoField* field, const std::vector<std::string>& strings) {
  if (auto* one = dynamic_cast<SoSFString*>(field)) one->setValue(strings.empty() ? "" : strings.front().c_str());
  if (auto* many = dynamic_cast<SoMFString*>(field)) {
    many->setNum(0);
    for (const std::string& string : strings) many->set1Value(many->getNum(), string.c_str());
  }
}

}  // namespace haptiv
