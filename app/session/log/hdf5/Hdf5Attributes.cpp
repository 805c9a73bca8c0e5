#include <algorithm>

#include "app/session/log/hdf5/Hdf5.h"

namespace haptiv::hdf5 {
namespace {

constexpr std::size_t kLongestAttribute = 4096;  // [bytes]
constexpr std::size_t kLongestList = 256;
constexpr const char* kFull = "Look for free space on that disk";

Handle textType(const std::filesystem::path& path, std::size_t length) {
  Handle type(checked(H5Tcopy(H5T_C_S1), path, "set up HDF5", ""), H5Tclose);
  checked(H5Tset_size(type.id(), std::max<std::size_t>(length, 1)), path, "set up a text", "");
  checked(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), path, "set up a text", "");
  return type;
}

Handle scalarSpace(const std::filesystem::path& path) {
  return {checked(H5Screate(H5S_SCALAR), path, "set up HDF5", ""), H5Sclose};
}

std::string reading(const char* attribute, const std::string& object) {
  return std::string("read the attribute ") + attribute + " of " + object;
}

/// An attribute as it stands in the file; throws where there is none.
struct StoredAttribute {
  StoredAttribute(const Handle& file, const std::filesystem::path& path, const std::string& object, const char* name)
      : attribute(checked(H5Aopen_by_name(file.id(), object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT), path,
                          reading(name, object), kDamaged),
                  H5Aclose),
        type(checked(H5Aget_type(attribute.id()), path, reading(name, object), kDamaged), H5Tclose),
        space(checked(H5Aget_space(attribute.id()), path, reading(name, object), kDamaged), H5Sclose) {}

  Handle attribute, type, space;
};

}  // namespace

void Attributes::writeTexts(const char* attribute, std::span<const std::string> texts, hid_t space) const {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, std::min(text.size(), kLongestAttribute));
  std::string block(length * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i].copy(block.data() + i * length, length);
  const Handle type = textType(path_, length);
  const Handle made(checked(H5Acreate_by_name(file_.id(), name_.c_str(), attribute, type.id(), space, H5P_DEFAULT,
                                              H5P_DEFAULT, H5P_DEFAULT),
                            path_, std::string("create ") + attribute, kFull),
                    H5Aclose);
  checked(H5Awrite(made.id(), type.id(), block.data()), path_, std::string("write ") + attribute, kFull);
}

void Attributes::write(const char* attribute, std::string_view text) const {
  const std::string copy(text);
  writeTexts(attribute, {&copy, 1}, scalarSpace(path_).id());
}

void Attributes::write(const char* attribute, const std::vector<std::string>& texts) const {
  const hsize_t count = texts.size();
  const Handle space(checked(H5Screate_simple(1, &count, nullptr), path_, "set up HDF5", ""), H5Sclose);
  writeTexts(attribute, texts, space.id());
}

void Attributes::writeNumber(const char* attribute, hid_t type, const void* value) const {
  const Handle space = scalarSpace(path_);
  const Handle made(checked(H5Acreate_by_name(file_.id(), name_.c_str(), attribute, type, space.id(), H5P_DEFAULT,
                                              H5P_DEFAULT, H5P_DEFAULT),
                            path_, std::string("create ") + attribute, kFull),
                    H5Aclose);
  checked(H5Awrite(made.id(), type, value), path_, std::string("write ") + attribute, kFull);
}

void Attributes::write(const char* attribute, std::uint64_t number) const {
  writeNumber(attribute, H5T_NATIVE_UINT64, &number);
}

void Attributes::write(const char* attribute, double number) const {
  writeNumber(attribute, H5T_NATIVE_DOUBLE, &number);
}

std::vector<std::string> Attributes::readTexts(const char* attribute, std::size_t most) const {
  const std::string what = reading(attribute, name_);
  const StoredAttribute stored(file_, path_, name_, attribute);
  const hssize_t count = H5Sget_simple_extent_npoints(stored.space.id());
  const std::size_t length = H5Tget_size(stored.type.id());
  if (H5Tget_class(stored.type.id()) != H5T_STRING || H5Tis_variable_str(stored.type.id()) != 0 || length == 0 ||
      length > kLongestAttribute || count < 0 || static_cast<std::size_t>(count) > most)
    fail(path_, "cannot " + what + ": it is no text of fixed length", kDamaged);
  std::string block(length * static_cast<std::size_t>(count), '\0');
  const Handle type = textType(path_, length);
  checked(H5Aread(stored.attribute.id(), type.id(), block.data()), path_, what, kDamaged);
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < block.size(); at += length) {
    const std::string padded = block.substr(at, length);
    texts.push_back(padded.substr(0, padded.find('\0')));
  }
  return texts;
}

std::string Attributes::text(const char* attribute) const {
  const std::vector<std::string> texts = readTexts(attribute, 1);
  return texts.empty() ? std::string() : texts.front();
}

std::vector<std::string> Attributes::texts(const char* attribute) const {
  return readTexts(attribute, kLongestList);
}

void Attributes::readNumber(const char* attribute, hid_t type, void* value) const {
  const std::string what = reading(attribute, name_);
  const StoredAttribute stored(file_, path_, name_, attribute);
  if (H5Tget_class(stored.type.id()) != H5Tget_class(type) || H5Sget_simple_extent_npoints(stored.space.id()) != 1)
    fail(path_, "cannot " + what + ": it is no such number", kDamaged);
  checked(H5Aread(stored.attribute.id(), type, value), path_, what, kDamaged);
}

std::uint64_t Attributes::integer(const char* attribute) const {
  std::uint64_t value = 0;
  readNumber(attribute, H5T_NATIVE_UINT64, &value);
  return value;
}

double Attributes::number(const char* attribute) const {
  double value = 0;
  readNumber(attribute, H5T_NATIVE_DOUBLE, &value);
  return value;
}

}  // namespace haptiv::hdf5
