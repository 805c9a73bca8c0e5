#include "scenegraph/reading/text/DeclaredFields.h"

#include <Inventor/SbName.h>
#include <Inventor/fields/SoField.h>
#include <Inventor/fields/SoFieldContainer.h>

#include <algorithm>

#include "scenegraph/Keyword.h"

namespace haptiv {
namespace {

/// Holds one instance while its fields are looked at.
class Probe {
 public:
  explicit Probe(SoType type) : instance_(static_cast<SoFieldContainer*>(type.createInstance())) { instance_->ref(); }
  ~Probe() { instance_->unref(); }
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  const SoField* field(const std::string& name) const { return instance_->getField(SbName(name.c_str())); }

 private:
  SoFieldContainer* instance_;
};

bool hasFields(SoType type) {
  return type.isDerivedFrom(SoFieldContainer::getClassTypeId()) && type.canCreateInstance();
}

std::string faultOf(const std::string& keyword, bool vrml2, const std::vector<std::string>& declared) {
  if (declared.size() % 2 != 0) return "the list of fields is not made of pairs, type and name: correct it";
  const SoType type = typeOfKeyword(keyword, vrml2);
  if (!hasFields(type)) return {};
  const Probe probe(type);
  for (std::size_t i = 0; i < declared.size(); i += 2) {
    const SoField* field = probe.field(declared[i + 1]);
    if (!field) {
      return "has no field \"" + declared[i + 1] +
             "\": correct its name, or open the file with the newer version that wrote it";
    }
    const std::string actual = field->getTypeId().getName().getString();
    if (actual != declared[i] && actual != "So" + declared[i]) {
      return "its field \"" + declared[i + 1] + "\" is declared as " + declared[i] + ": write " + actual;
    }
  }
  return {};
}

}  // namespace

std::string DeclaredFields::close(const std::string& keyword) {
  if (!isOpen_) return {};
  isOpen_ = false;
  return faultOf(keyword, vrml2_, words_);
}

bool hasFieldOf(const std::string& keyword, bool vrml2, const std::set<std::string>& names) {
  const SoType type = typeOfKeyword(keyword, vrml2);
  if (names.empty() || !hasFields(type)) return false;
  const Probe probe(type);
  return std::ranges::any_of(names, [&](const std::string& name) { return probe.field(name) != nullptr; });
}

}  // namespace haptiv
