#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "app/session/log/hdf5/Hdf5.h"

namespace haptiv::hdf5 {

/// What the cells of a table are.
enum class Cell { uint8, int16, int32, int64, float64 };
std::size_t sizeOf(Cell cell) noexcept;

/// A dataset that grows by rows, each of the same columns; every chunk is shuffled, packed and carries a checksum, so
/// that a flipped bit is an error and not a wrong number.
class Table {
 public:
  /// @param chunkRows  rows that are written at once
  static Table create(const Handle& file, const std::filesystem::path& path, const std::string& name, Cell cell,
                      std::size_t columns, std::size_t chunkRows);
  /// Throws where the dataset is missing or has other cells or columns; it may be hostile.
  static Table open(const Handle& file, const std::filesystem::path& path, const std::string& name, Cell cell,
                    std::size_t columns);

  /// Row-wise cells. @param rows  how many rows stand at `data`
  void append(const void* data, std::size_t rows);
  std::uint64_t rows() const noexcept { return rows_; }
  /// Reads rows [first, first + count), which must be there.
  void read(std::uint64_t first, std::size_t count, void* data) const;

 private:
  Table(Handle dataset, std::filesystem::path path, std::string name, Cell cell, std::size_t columns)
      : dataset_(std::move(dataset)), path_(std::move(path)), name_(std::move(name)), cell_(cell), columns_(columns) {}
  /// Rows that the dataset claims and has chunks for.
  std::uint64_t storedRows() const;
  Handle selectRows(std::uint64_t first, std::size_t count) const;

  Handle dataset_;
  std::filesystem::path path_;
  std::string name_;
  Cell cell_;
  std::size_t columns_;
  std::uint64_t rows_ = 0;
};

}  // namespace haptiv::hdf5
