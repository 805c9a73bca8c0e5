#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace haptiv {

/// From numbers to values in one flat table: a scene holds a hundred thousand shapes, and every edit asks for them all.
/// Values are only added. Open addressing; the table's size is a power of two.
template <typename Value>
class FlatMap {
 public:
  /// The value of a key; one that is met for the first time gets Value{}. The reference holds until the next call.
  Value& operator[](std::uint64_t key) {
    if (2 * count_ >= table_.size()) grow();
    Entry& entry = slot(key);
    if (!entry.isTaken) {
      entry.key = key;
      entry.isTaken = true;
      ++count_;
    }
    return entry.value;
  }

 private:
  struct Entry {
    std::uint64_t key = 0;
    Value value{};
    bool isTaken = false;
  };

  Entry& slot(std::uint64_t key) {
    std::uint64_t x = key * 0x9e3779b97f4a7c15U;
    x ^= x >> 32;
    for (;; ++x) {
      Entry& entry = table_[x & (table_.size() - 1)];
      if (!entry.isTaken || entry.key == key) return entry;
    }
  }

  void grow() {
    std::vector<Entry> before(table_.empty() ? 1024 : 4 * table_.size());
    before.swap(table_);
    for (Entry& entry : before) {
      if (entry.isTaken) slot(entry.key) = std::move(entry);
    }
  }

  std::vector<Entry> table_;
  std::size_t count_ = 0;
};

}  // namespace haptiv
