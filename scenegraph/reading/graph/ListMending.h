#pragma once

#include <cstdint>
#include <unordered_map>

class SoMField;
class SoNode;

namespace haptiv {

/// Lists of normals, materials and texture coordinates that are shorter than the shapes that use them, and how long
/// they must be. Coin reads on in whatever memory comes after them, which it mostly survives.
class ListMending {
 public:
  /// Whether so little is missing that it can be made up: files with a few values too few are common.
  static bool isWorthIt(std::int64_t needed, std::int64_t available);

  /// @param values  null: the material that is in force where there is none
  void add(const SoMField* values, std::int64_t needed);

  /// Repeats the last value of each list. The material that is in force where there is none becomes one, at the top.
  void mend(SoNode* root) const;

 private:
  std::unordered_map<const SoMField*, std::int64_t> needed_;
};

}  // namespace haptiv
