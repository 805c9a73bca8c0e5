#pragma once

#include <hdf5.h>

#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The part of HDF5's C interface that a session log needs. Every failing call throws std::runtime_error
/// "FILE: what, why, and what to do"; the library prints nothing itself.
namespace haptiv::hdf5 {

/// HDF5 keeps state of the whole process. Who calls into it holds this lock, so that no other thread is inside when a
/// log is probed in a child process (LogProbe.h).
class Lock {
 public:
  Lock();

 private:
  std::lock_guard<std::mutex> guard_;
};

/// Owns one identifier of the library and closes it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept;
  ~Handle() { reset(); }

  hid_t id() const noexcept { return id_; }
  explicit operator bool() const noexcept { return id_ >= 0; }
  void reset() noexcept;

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// The remedy where a file holds something else than it should.
inline constexpr const char* kDamaged = "The file is damaged or is no session log: use another copy of it";

/// What HDF5 says of its last failure, in brackets; empty if nothing.
std::string lastFailure();

/// Throws std::runtime_error "FILE: cannot WHAT (HDF5's own words). REMEDY" where `result` is negative.
/// T: hid_t or herr_t.
template <typename T>
T checked(T result, const std::filesystem::path& file, std::string_view what, std::string_view remedy);
[[noreturn]] void fail(const std::filesystem::path& file, std::string_view what, std::string_view remedy);

template <typename T>
T checked(T result, const std::filesystem::path& file, std::string_view what, std::string_view remedy) {
  if (result < 0) fail(file, std::string("cannot ") + std::string(what) + lastFailure(), remedy);
  return result;
}

/// Creates a file in the format and with the paging that survive kill -9 and power cuts, over any there is.
Handle createFile(const std::filesystem::path& path);
/// From here on readers can follow and crashes do no harm, but no new object or attribute can come.
void startSwmr(const Handle& file, const std::filesystem::path& path);
/// HDF5's caches into the file, and the file to the disk (fdatasync).
void flushToDisk(const Handle& file, const std::filesystem::path& path);
/// From here on no byte reaches the file: after a failed write, HDF5's own closing would make it unreadable, while like
/// this it stays as a crash would leave it. It is to be closed next.
void abandon(const Handle& file) noexcept;
/// Opens for reading; `closedWell` becomes false where its writer did not close it.
Handle openFile(const std::filesystem::path& path, bool& closedWell);
/// A new folder within the file.
void createGroup(const Handle& file, const std::filesystem::path& path, const char* name);

/// Attributes of the object `name` in a file: texts of fixed length, lists of them, and numbers.
class Attributes {
 public:
  Attributes(const Handle& file, const std::filesystem::path& path, std::string name)
      : file_(file), path_(path), name_(std::move(name)) {}

  void write(const char* attribute, std::string_view text) const;
  void write(const char* attribute, const std::vector<std::string>& texts) const;
  void write(const char* attribute, std::uint64_t number) const;
  void write(const char* attribute, double number) const;

  std::string text(const char* attribute) const;
  std::vector<std::string> texts(const char* attribute) const;
  std::uint64_t integer(const char* attribute) const;
  double number(const char* attribute) const;

 private:
  std::vector<std::string> readTexts(const char* attribute, std::size_t most) const;
  void writeTexts(const char* attribute, std::span<const std::string> texts, hid_t space) const;
  void writeNumber(const char* attribute, hid_t type, const void* value) const;
  void readNumber(const char* attribute, hid_t type, void* value) const;

  const Handle& file_;
  const std::filesystem::path& path_;
  std::string name_;
};

}  // namespace haptiv::hdf5
