#include "scenegraph/reading/files/FontNames.h"

#include <fontconfig/fontconfig.h>

#include <memory>

namespace haptiv {
namespace {

struct Destroy {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, Destroy>;

const FcChar8* bytes(const std::string& text) {
  return reinterpret_cast<const FcChar8*>(text.c_str());
}

/// A font may have names in several languages. Null: it has no more.
const FcChar8* familyOf(const Pattern& font, int index) {
  FcChar8* name = nullptr;
  return FcPatternGetString(font.get(), FC_FAMILY, index, &name) == FcResultMatch ? name : nullptr;
}

}  // namespace

std::string fontInPlaceOf(const std::string& name) {
  const std::string family = name.substr(0, name.find(':'));
  const Pattern wanted(FcPatternCreate());
  if (!wanted || !FcPatternAddString(wanted.get(), FC_FAMILY, bytes(family))) return {};
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(nullptr, wanted.get(), &result));
  if (!found) return {};  // the system has no font at all
  for (int i = 0; const FcChar8* one = familyOf(found, i); ++i) {
    if (FcStrCmpIgnoreCase(one, bytes(family)) == 0) return {};
  }
  const FcChar8* first = familyOf(found, 0);
  return first ? reinterpret_cast<const char*>(first) : std::string();
}

}  // namespace haptiv
