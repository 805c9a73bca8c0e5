#include "haptics/bytes/ChoiceBytes.h"

#include <string>

namespace haptiv {
namespace {

constexpr std::uint8_t kAsDescribed = 255;

/// An enumerator whose last one is `last`.
template <typename Choice>
Choice readChoice(ByteReader& in, Choice last, const std::string& what) {
  const std::uint8_t number = in.u8();
  if (number > static_cast<std::uint8_t>(last)) in.fail("unknown " + what);
  return static_cast<Choice>(number);
}

}  // namespace

void write(ByteWriter& out, const std::optional<ResolutionChoice>& choice) {
  out.u8(choice ? static_cast<std::uint8_t>(choice->strategy) : kAsDescribed);
  out.u8(choice ? static_cast<std::uint8_t>(choice->solution) : kAsDescribed);
}

std::optional<ResolutionChoice> readResolution(ByteReader& in) {
  const std::uint8_t strategy = in.u8();
  const std::uint8_t solution = in.u8();
  if (strategy == kAsDescribed && solution == kAsDescribed) return {};
  if (strategy > static_cast<std::uint8_t>(Strategy::cond)) in.fail("unknown strategy of the redundancy");
  if (solution > static_cast<std::uint8_t>(Solution::partitioned)) in.fail("unknown solution of the redundancy");
  return ResolutionChoice{static_cast<Strategy>(strategy), static_cast<Solution>(solution)};
}

void write(ByteWriter& out, const std::optional<ControlChoice>& choice) {
  out.u8(choice ? static_cast<std::uint8_t>(choice->display) : kAsDescribed);
  if (!choice) return;
  out.u8(static_cast<std::uint8_t>(choice->joints));
  out.u8(static_cast<std::uint8_t>(choice->orientation));
  out.u8(choice->passivity ? 1 : 0);
}

std::optional<ControlChoice> readControl(ByteReader& in) {
  const std::uint8_t display = in.u8();
  if (display == kAsDescribed) return {};
  if (display > static_cast<std::uint8_t>(DisplayMode::impedance)) in.fail("unknown mode of display");
  ControlChoice choice;
  choice.display = static_cast<DisplayMode>(display);
  choice.joints = readChoice(in, JointController::computedTorque, "joint controller");
  choice.orientation = readChoice(in, OrientationMode::free, "mode of orientation");
  const std::uint8_t passivity = in.u8();
  if (passivity > 1) in.fail("unknown choice of passivity");
  choice.passivity = passivity == 1;
  return choice;
}

}  // namespace haptiv
