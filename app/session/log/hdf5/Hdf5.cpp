#include "app/session/log/hdf5/Hdf5.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace haptiv::hdf5 {
namespace {

constexpr hsize_t kPageSize = 4096;

std::mutex& processLock() {
  static std::mutex mutex;
  // What is opened here is closed here; HDF5's own clean-up at the program's end crashes after a failed write.
  [[maybe_unused]] static const herr_t first = H5dont_atexit();
  return mutex;
}

herr_t takeDescription(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

Handle accessList(const std::filesystem::path& path) {
  Handle list(checked(H5Pcreate(H5P_FILE_ACCESS), path, "set up HDF5", ""), H5Pclose);
  checked(H5Pset_libver_bounds(list.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), path, "choose the file format", "");
  checked(H5Pset_file_locking(list.id(), true, true), path, "choose how the file is locked", "");
  checked(H5Pset_fclose_degree(list.id(), H5F_CLOSE_STRONG), path, "choose how the file is closed", "");
  return list;
}

}  // namespace

Lock::Lock() : guard_(processLock()) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle& Handle::operator=(Handle&& other) noexcept {
  if (this == &other) return *this;
  reset();
  id_ = std::exchange(other.id_, H5I_INVALID_HID);
  close_ = other.close_;
  return *this;
}

void Handle::reset() noexcept {
  if (id_ >= 0) close_(id_);
  id_ = H5I_INVALID_HID;
}

std::string lastFailure() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, takeDescription, &text);
  return text.empty() ? text : " (" + text + ")";
}

void fail(const std::filesystem::path& file, std::string_view what, std::string_view remedy) {
  std::string message = file.string() + ": " + std::string(what);
  if (!remedy.empty()) message += ". " + std::string(remedy);
  throw std::runtime_error(message);
}

Handle createFile(const std::filesystem::path& path) {
  const Handle access = accessList(path);
  const Handle creation(checked(H5Pcreate(H5P_FILE_CREATE), path, "set up HDF5", ""), H5Pclose);
  checked(H5Pset_obj_track_times(creation.id(), false), path, "leave out times", "");
  checked(H5Pset_file_space_strategy(creation.id(), H5F_FSPACE_STRATEGY_PAGE, false, 1), path, "choose paging", "");
  checked(H5Pset_file_space_page_size(creation.id(), kPageSize), path, "choose the page size", "");
  return {checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), path, "create the session log",
                  "Choose a folder that exists and can be written to, and a file that no session is writing"),
          H5Fclose};
}

void startSwmr(const Handle& file, const std::filesystem::path& path) {
  checked(H5Fstart_swmr_write(file.id()), path, "make the session log safe against crashes",
          "Choose a folder on a local disk");
}

void flushToDisk(const Handle& file, const std::filesystem::path& path) {
  constexpr const char* kRemedy = "Look for free space on that disk; what was written before stays readable";
  checked(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), path, "write to the session log", kRemedy);
  void* descriptor = nullptr;
  checked(H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &descriptor), path, "reach the session log's file", kRemedy);
  if (fdatasync(*static_cast<int*>(descriptor)) != 0)
    fail(path, "cannot bring the session log to the disk: " + std::generic_category().message(errno), kRemedy);
}

void abandon(const Handle& file) noexcept {
  void* descriptor = nullptr;
  const int elsewhere = memfd_create("abandoned session log", MFD_CLOEXEC);
  if (elsewhere >= 0 && H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &descriptor) >= 0)
    dup2(elsewhere, *static_cast<int*>(descriptor));
  if (elsewhere >= 0) close(elsewhere);
}

Handle openFile(const std::filesystem::path& path, bool& closedWell) {
  const Handle access = accessList(path);
  closedWell = true;
  if (Handle plain(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose); plain) return plain;
  closedWell = false;
  return {checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.id()), path,
                  "open the session log: it is damaged", "Use another copy of it"),
          H5Fclose};
}

void createGroup(const Handle& file, const std::filesystem::path& path, const char* name) {
  const Handle creation(checked(H5Pcreate(H5P_GROUP_CREATE), path, "set up HDF5", ""), H5Pclose);
  checked(H5Pset_obj_track_times(creation.id(), false), path, "leave out times", "");
  Handle(checked(H5Gcreate2(file.id(), name, H5P_DEFAULT, creation.id(), H5P_DEFAULT), path,
                 std::string("create ") + name, "Look for free space on that disk"),
         H5Gclose);
}

}  // namespace haptiv::hdf5
