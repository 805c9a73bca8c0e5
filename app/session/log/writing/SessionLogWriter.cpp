#include "app/session/log/writing/SessionLogWriter.h"

#include "app/session/log/writing/SessionLogFile.h"

namespace haptiv {

std::uint64_t freeSpaceFor(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if (error) hdf5::fail(file, "cannot write a session log there: " + error.message(), "Choose a folder that exists");
  return space.available;
}

SessionLogWriter::SessionLogWriter(const std::filesystem::path& path, const SessionHeader& header,
                                   FreeSpace freeSpace) {
  const hdf5::Lock lock;
  file_ = std::make_unique<File>(path, header, std::move(freeSpace));
}

SessionLogWriter::~SessionLogWriter() {
  const hdf5::Lock lock;
  try {
    if (file_->isOpen()) file_->writeOut(true);
  } catch (const std::exception&) {  // whoever wants to know calls flush or close
  }
  file_.reset();
}

void SessionLogWriter::addScene(const HapticScene& scene, const std::string& text) {
  const hdf5::Lock lock;
  file_->expectOpen();
  file_->add(scene, text);
}

void SessionLogWriter::append(std::span<const TickRecord> ticks) {
  const hdf5::Lock lock;
  file_->expectOpen();
  for (const TickRecord& tick : ticks) file_->add(tick);
  file_->writeOut(false);
}

void SessionLogWriter::flush() {
  const hdf5::Lock lock;
  file_->expectOpen();
  file_->writeOut(true);
}

void SessionLogWriter::close(std::uint64_t dropped) {
  const hdf5::Lock lock;
  if (file_->isOpen()) file_->end(dropped);
}

}  // namespace haptiv
