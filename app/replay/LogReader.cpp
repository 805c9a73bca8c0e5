#include "app/replay/LogReader.h"

#include <algorithm>
#include <stdexcept>

namespace haptiv {

LogReader::LogReader(const SessionLog& log) : log_(log), count_(log.tickCount()) {}

const LogReader::Block& LogReader::block(std::uint64_t number) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Block& b) { return b.number == number; });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return kept_.front();
  }
  const std::uint64_t first = number * kBlock;
  Block read{number, log_.ticks(first, kBlock)};
  if (read.ticks.size() < std::min(kBlock, count_ - first)) {
    throw std::runtime_error("The log ends before tick " + std::to_string(first + kBlock) +
                             ", though its head promises more. What lies before can be replayed.");
  }
  if (kept_.size() == kBlocksKept) kept_.pop_back();
  kept_.push_front(std::move(read));
  return kept_.front();
}

const TickRecord& LogReader::at(std::uint64_t index) {
  return block(index / kBlock).ticks[index % kBlock];
}

std::uint64_t LogReader::indexAt(std::int64_t time) {
  const auto within = [time](const Block& b) {  // how many of its ticks are not later
    return std::upper_bound(b.ticks.begin(), b.ticks.end(), time,
                            [](std::int64_t t, const TickRecord& record) { return t < record.time; }) -
           b.ticks.begin();
  };
  std::uint64_t answer = 0;
  std::uint64_t first = 0;  // the blocks in question: [first, end)
  std::uint64_t end = (count_ + kBlock - 1) / kBlock;
  double firstTime = static_cast<double>(at(0).time);
  double endTime = static_cast<double>(at(count_ - 1).time);
  // Logs are nearly regular, so a straight line finds the block at once; every other time the middle, for those that
  // are not.
  for (bool straight = true; first < end; straight = !straight) {
    const double share = endTime > firstTime ? (static_cast<double>(time) - firstTime) / (endTime - firstTime) : 0;
    const auto ahead = static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(end - first));
    const std::uint64_t guess = straight ? std::min(first + ahead, end - 1) : first + (end - first) / 2;
    const Block& b = block(guess);
    if (time < b.ticks.front().time) {
      end = guess;
      endTime = static_cast<double>(b.ticks.front().time);
    } else {
      answer = guess * kBlock + static_cast<std::uint64_t>(within(b)) - 1;
      if (time < b.ticks.back().time) return answer;
      first = guess + 1;
      firstTime = static_cast<double>(b.ticks.back().time);
    }
  }
  return answer;
}

}  // namespace haptiv
