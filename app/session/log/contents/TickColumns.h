#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session/log/hdf5/Hdf5Table.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// One number of a TickRecord as it stands in a log: what the writer, the reader, the export and the names of
/// differences all go by.
struct TickColumn {
  std::string name;  ///< with its unit, such as "desired_position_x_m"
  std::string unit;  ///< "1" where it has none
  bool result;       ///< computed by HapticTick, so a re-simulation must give the same bits
  std::function<void(const TickRecord&, std::byte*)> store;  ///< into a cell of the group's type
  std::function<void(TickRecord&, const std::byte*)> load;   ///< back, bit for bit
  std::function<double(const TickRecord&)> value;            ///< for people
  std::uint64_t since = 2;                                   ///< format of the first logs that all have it
};

/// Columns that are stored together, as the dataset /servo/NAME.
struct TickGroup {
  std::string name;
  std::string frame;  ///< W, B or T; empty where there is none
  hdf5::Cell cell;
  std::vector<TickColumn> columns;

  std::size_t rowSize() const { return columns.size() * hdf5::sizeOf(cell); }  ///< [bytes]
};

/// All of a TickRecord.
std::vector<TickGroup> tickGroups();

}  // namespace haptiv
