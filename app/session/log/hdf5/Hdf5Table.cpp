#include "app/session/log/hdf5/Hdf5Table.h"

#include <algorithm>
#include <array>

namespace haptiv::hdf5 {
namespace {

constexpr const char* kTableFull = "Look for free space on that disk; what was written before stays readable";
constexpr hsize_t kLargestChunk = 64u << 20;  // [bytes], as far as a hostile file may make us allocate

hid_t nativeType(Cell cell) {
  switch (cell) {
    case Cell::uint8:
      return H5T_NATIVE_UINT8;
    case Cell::int16:
      return H5T_NATIVE_INT16;
    case Cell::int32:
      return H5T_NATIVE_INT32;
    case Cell::int64:
      return H5T_NATIVE_INT64;
    case Cell::float64:
      break;
  }
  return H5T_NATIVE_DOUBLE;
}

hid_t storedType(Cell cell) {
  switch (cell) {
    case Cell::uint8:
      return H5T_STD_U8LE;
    case Cell::int16:
      return H5T_STD_I16LE;
    case Cell::int32:
      return H5T_STD_I32LE;
    case Cell::int64:
      return H5T_STD_I64LE;
    case Cell::float64:
      break;
  }
  return H5T_IEEE_F64LE;
}

}  // namespace

std::size_t sizeOf(Cell cell) noexcept {
  switch (cell) {
    case Cell::uint8:
      return 1;
    case Cell::int16:
      return 2;
    case Cell::int32:
      return 4;
    case Cell::int64:
    case Cell::float64:
      break;
  }
  return 8;
}

Table Table::create(const Handle& file, const std::filesystem::path& path, const std::string& name, Cell cell,
                    std::size_t columns, std::size_t chunkRows) {
  const std::array<hsize_t, 2> none{0, columns}, most{H5S_UNLIMITED, columns}, chunk{chunkRows, columns};
  const Handle space(checked(H5Screate_simple(2, none.data(), most.data()), path, "set up HDF5", ""), H5Sclose);
  const Handle creation(checked(H5Pcreate(H5P_DATASET_CREATE), path, "set up HDF5", ""), H5Pclose);
  checked(H5Pset_chunk(creation.id(), 2, chunk.data()), path, "set up chunks", "");
  checked(H5Pset_shuffle(creation.id()), path, "set up shuffling", "");
  checked(H5Pset_deflate(creation.id(), 1), path, "set up packing", "");
  checked(H5Pset_fletcher32(creation.id()), path, "set up checksums", "");
  checked(H5Pset_obj_track_times(creation.id(), false), path, "leave out times", "");
  return {Handle(checked(H5Dcreate2(file.id(), name.c_str(), storedType(cell), space.id(), H5P_DEFAULT, creation.id(),
                                    H5P_DEFAULT),
                         path, "create " + name, kTableFull),
                 H5Dclose),
          path, name, cell, columns};
}

Table Table::open(const Handle& file, const std::filesystem::path& path, const std::string& name, Cell cell,
                  std::size_t columns) {
  Handle dataset(checked(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), path, "open " + name, kDamaged), H5Dclose);
  const Handle type(checked(H5Dget_type(dataset.id()), path, "read the type of " + name, kDamaged), H5Tclose);
  if (H5Tequal(type.id(), storedType(cell)) <= 0)
    fail(path, name + " does not hold the numbers that a session log has there", kDamaged);
  Table table(std::move(dataset), path, name, cell, columns);
  table.rows_ = table.storedRows();
  return table;
}

std::uint64_t Table::storedRows() const {
  const std::string what = "read the size of " + name_;
  const Handle space(checked(H5Dget_space(dataset_.id()), path_, what, kDamaged), H5Sclose);
  std::array<hsize_t, 2> extent{}, chunk{};
  if (H5Sget_simple_extent_ndims(space.id()) != 2 ||
      H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr) != 2 || extent[1] != columns_)
    fail(path_, name_ + " has not the " + std::to_string(columns_) + " columns of a session log", kDamaged);
  const Handle creation(checked(H5Dget_create_plist(dataset_.id()), path_, what, kDamaged), H5Pclose);
  if (H5Pget_layout(creation.id()) != H5D_CHUNKED || H5Pget_chunk(creation.id(), 2, chunk.data()) != 2 ||
      chunk[1] != columns_ || chunk[0] == 0 || chunk[0] > kLargestChunk / columns_ / sizeOf(cell_))
    fail(path_, name_ + " is not stored in chunks of rows", kDamaged);
  hsize_t chunks = 0;
  checked(H5Dget_num_chunks(dataset_.id(), space.id(), &chunks), path_, "count the chunks of " + name_, kDamaged);
  return std::min<hsize_t>(extent[0], chunks * chunk[0]);
}

Handle Table::selectRows(std::uint64_t first, std::size_t count) const {
  const std::string what = "find rows of " + name_;
  const std::array<hsize_t, 2> start{first, 0}, size{count, columns_};
  Handle space(checked(H5Dget_space(dataset_.id()), path_, what, kDamaged), H5Sclose);
  checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr), path_, what,
          kDamaged);
  return space;
}

void Table::append(const void* data, std::size_t rows) {
  if (rows == 0) return;
  const std::array<hsize_t, 2> extent{rows_ + rows, columns_}, size{rows, columns_};
  checked(H5Dset_extent(dataset_.id(), extent.data()), path_, "make room in " + name_, kTableFull);
  const Handle target = selectRows(rows_, rows);
  const Handle source(checked(H5Screate_simple(2, size.data(), nullptr), path_, "set up HDF5", ""), H5Sclose);
  checked(H5Dwrite(dataset_.id(), nativeType(cell_), source.id(), target.id(), H5P_DEFAULT, data), path_,
          "write " + name_, kTableFull);
  rows_ += rows;
}

void Table::read(std::uint64_t first, std::size_t count, void* data) const {
  if (count == 0) return;
  const std::array<hsize_t, 2> size{count, columns_};
  const Handle source = selectRows(first, count);
  const Handle target(checked(H5Screate_simple(2, size.data(), nullptr), path_, "set up HDF5", ""), H5Sclose);
  checked(H5Dread(dataset_.id(), nativeType(cell_), target.id(), source.id(), H5P_DEFAULT, data), path_,
          "read rows " + std::to_string(first) + " to " + std::to_string(first + count - 1) + " of " + name_,
          "That part of the file is damaged: use another copy of it");
}

}  // namespace haptiv::hdf5
