#include "scenegraph/reading/graph/ListMending.h"

#include <Inventor/fields/SoMFColor.h>
#include <Inventor/fields/SoMFInt32.h>
#include <Inventor/fields/SoMFUInt32.h>
#include <Inventor/fields/SoMFVec2f.h>
#include <Inventor/fields/SoMFVec3f.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoMaterial.h>

#include <algorithm>

namespace haptiv {
namespace {

template <typename Field>
bool repeatLast(SoMField* values, int count) {
  auto* field = dynamic_cast<Field*>(values);
  if (!field) return false;
  const int before = field->getNum();
  if (before == 0 || before >= count) return true;
  const auto last = (*field)[before - 1];
  field->setNum(count);
  auto* all = field->startEditing();
  std::fill(all + before, all + count, last);
  field->finishEditing();
  return true;
}

/// In step with the coordinates' index, for it is read so where vertices go by it; the -1 that end faces are then
/// passed over, and count as 0 where faces go by it.
void fill(SoMFInt32& index, const SoMFInt32& coordIndex, std::int64_t count) {
  index.setNum(coordIndex.getNum());
  int32_t* values = index.startEditing();
  std::transform(coordIndex.getValues(0), coordIndex.getValues(0) + coordIndex.getNum(), values,
                 [&](int32_t at) { return static_cast<int32_t>(std::clamp<std::int64_t>(at, 0, count - 1)); });
  index.finishEditing();
}

}  // namespace

bool ListMending::isWorthIt(std::int64_t needed, std::int64_t available) {
  static constexpr std::int64_t kFew = 1000;
  return needed <= 2 * available + kFew;
}

void ListMending::add(const SoMField* values, std::int64_t needed) {
  needed_[values] = std::max(needed_[values], needed);
}

void ListMending::add(const SoMFInt32& index, const SoMFInt32& coordIndex, std::int64_t count) {
  const auto [known, isNew] = missing_.try_emplace(&index, MissingIndex{&coordIndex, count});
  if (!isNew) known->second.count = std::min(known->second.count, count);
}

void ListMending::mend(SoNode* root) const {
  for (const auto& [index, missing] : missing_)
    fill(*const_cast<SoMFInt32*>(index), *missing.coordIndex, missing.count);
  for (const auto& [values, needed] : needed_) {
    auto* list = const_cast<SoMField*>(values);
    const int count = static_cast<int>(needed);
    if (list) {
      repeatLast<SoMFVec3f>(list, count) || repeatLast<SoMFVec2f>(list, count) || repeatLast<SoMFColor>(list, count) ||
          repeatLast<SoMFUInt32>(list, count);
    } else if (auto* group = dynamic_cast<SoGroup*>(root)) {
      auto* material = new SoMaterial;
      repeatLast<SoMFColor>(&material->diffuseColor, count);
      group->insertChild(material, 0);
    }
  }
}

}  // namespace haptiv
