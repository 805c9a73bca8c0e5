#include "scenegraph/reading/files/SceneBytes.h"

#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

namespace haptiv {
namespace {

namespace fs = std::filesystem;

/// Why a path cannot be read as a scene; empty where it can.
std::string pathFault(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return "there is no such file: check its name and folder";
  if (error) return "cannot be looked at: " + error.message();
  if (fs::is_directory(status)) return "is a folder: name a scene file in it";
  if (!fs::is_regular_file(status)) return "is not a regular file: name a scene file";
  if (fs::file_size(path, error) > kMaxSceneBytes) return "is larger than 256 MB: split or simplify it";
  return {};
}

/// zlib's state, which is its own to end.
class Inflater {
 public:
  explicit Inflater(std::string& packed) {
    stream_.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream_.avail_in = static_cast<uInt>(packed.size());
    static constexpr int kGzip = 15 + 16;  // the largest window, and gzip's header
    ready_ = inflateInit2(&stream_, kGzip) == Z_OK;
  }
  ~Inflater() {
    if (ready_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// One piece of the contents; a gzip file may be several, one after the other.
  int next(std::string& piece) {
    if (!ready_) return Z_MEM_ERROR;
    piece.resize(kPiece);
    stream_.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream_.avail_out = static_cast<uInt>(piece.size());
    const int result = inflate(&stream_, Z_NO_FLUSH);
    piece.resize(piece.size() - stream_.avail_out);
    if (result == Z_STREAM_END && stream_.avail_in > 2 && stream_.next_in[0] == 0x1f && stream_.next_in[1] == 0x8b) {
      return inflateReset(&stream_);
    }
    return result;
  }

 private:
  static constexpr std::size_t kPiece = 1 << 18;
  z_stream stream_{};
  bool ready_ = false;
};

}  // namespace

SceneBytes unpackScene(std::string bytes) {
  if (bytes.size() > kMaxSceneBytes) return {{}, "is larger than 256 MB: split or simplify it"};
  if (!bytes.starts_with("\x1f\x8b")) return {std::move(bytes), {}};
  Inflater inflater(bytes);
  SceneBytes unpacked;
  for (std::string piece;;) {
    const int result = inflater.next(piece);
    unpacked.bytes += piece;
    if (unpacked.bytes.size() > kMaxSceneBytes) return {{}, "unpacks to more than 256 MB: split or simplify it"};
    if (result == Z_STREAM_END) return unpacked;
    if (result != Z_OK) return {{}, "is gzipped, and broken or cut off: fetch it again"};
  }
}

SceneBytes readSceneBytes(const fs::path& path) {
  const std::string fault = pathFault(path);
  if (!fault.empty()) return {{}, fault};
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  if (in) bytes.assign(std::istreambuf_iterator<char>(in), {});
  if (!in || in.bad()) return {{}, std::string("cannot be read: ") + std::strerror(errno) + ": check its permissions"};
  return unpackScene(std::move(bytes));
}

}  // namespace haptiv
