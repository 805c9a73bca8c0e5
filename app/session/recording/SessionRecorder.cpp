#include "app/session/recording/SessionRecorder.h"

#include <chrono>
#include <exception>

namespace haptiv {
namespace {

constexpr std::chrono::milliseconds kDrainInterval(50);

std::size_t shapesOf(const HapticScene& scene) {
  return scene.walls.size() + scene.zones.size();
}

}  // namespace

SessionRecorder::SessionRecorder(RecordRing<TickRecord>& ring, std::unique_ptr<SessionLogWriter> writer,
                                 std::unique_ptr<FlightRecorder> flights)
    : ring_(ring), writer_(std::move(writer)), flights_(std::move(flights)), thread_([this] { run(); }) {}

SessionRecorder::~SessionRecorder() {
  stop();
}

void SessionRecorder::addScene(std::shared_ptr<const HapticScene> scene, SharedText text) {
  const std::lock_guard guard(mutex_);
  shapesToLog_ += shapesOf(*scene);
  newScenes_.push_back({std::move(scene), std::move(text)});
}

std::size_t SessionRecorder::shapesToLog() const {
  const std::lock_guard guard(mutex_);
  return shapesToLog_;
}

std::string SessionRecorder::trouble() const {
  const std::lock_guard guard(mutex_);
  return trouble_;
}

SessionSummary SessionRecorder::stop() {
  if (!thread_.joinable()) return summary_;
  {
    const std::lock_guard guard(mutex_);
    stopping_ = true;
  }
  wake_.notify_one();
  thread_.join();
  summary_.droppedRecords = ring_.dropped();
  summary_.ticks += summary_.droppedRecords;
  if (flights_) summary_.flights = flights_->files();
  return summary_;
}

void SessionRecorder::run() {
  for (bool last = false; !last;) {
    {
      std::unique_lock guard(mutex_);
      last = wake_.wait_for(guard, kDrainInterval, [this] { return stopping_; });
    }
    drain();
  }
  endLog();
}

void SessionRecorder::drain() {
  block_.clear();
  ring_.drain([this](const TickRecord& record) {
    summary_.take(record);
    block_.push_back(record);
  });
  std::vector<NewScene> scenes;  // taken after the ticks, so that every tick's scene is among them
  {
    const std::lock_guard guard(mutex_);
    scenes.swap(newScenes_);
  }
  withLog([&] {
    for (const NewScene& scene : scenes) writer_->addScene(*scene.scene, scene.text.get());
    writer_->append(block_);
  });
  noteWritten(scenes);
  if (!flights_) return;
  for (NewScene& scene : scenes) flights_->addScene(std::move(scene.scene), std::move(scene.text));
  for (const TickRecord& record : block_) recordFlight(record);
}

void SessionRecorder::noteWritten(const std::vector<NewScene>& scenes) {
  const std::lock_guard guard(mutex_);
  for (const NewScene& scene : scenes) shapesToLog_ -= shapesOf(*scene.scene);
}

void SessionRecorder::recordFlight(const TickRecord& record) {
  try {
    flights_->take(record);
  } catch (const std::exception& error) {
    tell(error.what());
  }
}

void SessionRecorder::endLog() {
  const std::uint64_t dropped = ring_.dropped();
  withLog([&] { writer_->close(dropped); });
  writer_.reset();
  if (dropped > 0)
    tell(std::to_string(dropped) +
         " ticks never reached the log: the machine was too busy. Close other programs, or log to a faster disk");
}

void SessionRecorder::tell(const std::string& trouble) {
  const std::lock_guard guard(mutex_);
  trouble_ += (trouble_.empty() ? "" : "\n") + trouble;
}

template <typename Step>
void SessionRecorder::withLog(Step&& step) {
  if (!writer_) return;
  try {
    step();
  } catch (const std::exception& error) {
    tell(error.what());
    writer_.reset();
  }
}

}  // namespace haptiv
