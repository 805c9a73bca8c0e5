#pragma once

#include <cstdint>
#include <unordered_map>

class SoMFInt32;
class SoMField;
class SoNode;

namespace haptiv {

/// Lists of normals, materials and texture coordinates that are shorter than the shapes that use them, and how long
/// they must be; and indices that are not there. Coin reads on in whatever memory comes after them, which it mostly
/// survives.
class ListMending {
 public:
  /// Whether so little is missing that it can be made up: files with a few values too few are common.
  static bool isWorthIt(std::int64_t needed, std::int64_t available);

  /// @param values  null: the material that is in force where there is none
  void add(const SoMField* values, std::int64_t needed);

  /// @param index   without a value, of an attribute that has `count` values and goes by it face by face
  /// @param coordIndex  of the same shape
  void add(const SoMFInt32& index, const SoMFInt32& coordIndex, std::int64_t count);

  /// Repeats the last value of each list; gives each index the values of the coordinates', as Coin does when it draws.
  /// The material that is in force where there is none becomes one, at the top.
  void mend(SoNode* root) const;

 private:
  struct MissingIndex {
    const SoMFInt32* coordIndex = nullptr;
    std::int64_t count = 0;  ///< of values, at the place where there are fewest
  };
  std::unordered_map<const SoMField*, std::int64_t> needed_;
  std::unordered_map<const SoMFInt32*, MissingIndex> missing_;
};

}  // namespace haptiv
