#include "device/usb/spacemouse/SpaceMouseReport.h"

#include <algorithm>

#include "device/usb/protocol/WireBytes.h"

namespace haptiv {
namespace {

constexpr std::size_t kThreeAxes = 6, kSixAxes = 12;  // [bytes]

enum ReportId : std::uint8_t { kTranslation = 1, kRotation = 2, kButtons = 3 };

void takeAxes(std::span<const std::uint8_t> bytes, std::size_t first, SpaceMouseState& state) noexcept {
  usb::WireReader reader(bytes);
  for (std::size_t i = first; i < first + bytes.size() / 2; ++i) state.axes[i] = reader.signedInteger<std::int16_t>();
}

/// False: it tells nothing that is known.
bool take(std::uint8_t id, std::span<const std::uint8_t> bytes, std::int64_t now, SpaceMouseState& state) noexcept {
  if (id == kButtons && !bytes.empty()) {
    const auto known = bytes.first(std::min<std::size_t>(bytes.size(), 4));
    state.buttons = usb::WireReader(known).unsignedInteger<std::uint32_t>(static_cast<int>(known.size()));
    return true;
  }
  if ((id != kTranslation && id != kRotation) || bytes.size() < kThreeAxes) return false;
  const bool all = id == kTranslation && bytes.size() >= kSixAxes;
  takeAxes(bytes.first(all ? kSixAxes : kThreeAxes), id == kRotation ? 3 : 0, state);
  state.time = now;
  return true;
}

}  // namespace

void takeReport(std::span<const std::uint8_t> report, std::int64_t now, SpaceMouseState& state) noexcept {
  const bool understood = !report.empty() && take(report[0], report.subspan(1), now, state);
  ++(understood ? state.reports : state.ignored);
}

}  // namespace haptiv
