#include "device/usb/protocol/SetPoints.h"
#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

namespace {

enum CommandFlag : std::uint8_t {
  kEnable = 1u << 0,
  kBrake = 1u << 1,  // the opposite of kEnable: a frame in which they agree is refused
  kReset = 1u << 2,
  kTrip = 1u << 3,
};
constexpr std::uint8_t kCommandFlags = kEnable | kBrake | kReset | kTrip;

std::uint8_t flagsOf(const BoardCommand& command) noexcept {
  return static_cast<std::uint8_t>((command.drive.enabled ? kEnable : kBrake) | (command.reset ? kReset : 0) |
                                   (command.trip ? kTrip : 0));
}

/// The number nearest to `before` whose lower 16 bits these are.
std::uint32_t nearest16(std::uint16_t low, std::uint32_t before) noexcept {
  return before + static_cast<std::uint32_t>(static_cast<std::int16_t>(low - static_cast<std::uint16_t>(before)));
}

}  // namespace

std::span<const std::uint8_t> encodeCommand(const BoardCommand& command, FrameForm form,
                                            std::span<std::uint8_t, kLargestFrame> out) noexcept {
  const bool full = form == FrameForm::full;
  const DriveMode mode = command.drive.mode;
  const JointVector& setPoints = mode == DriveMode::torque ? command.drive.jointTorques : command.drive.jointRates;
  WireWriter writer(out);
  writeHead(writer, full ? FrameType::command : FrameType::packedCommand);
  writer.integer(command.sequence, full ? 4 : 2);
  writer.integer(command.heartbeat, full ? 4 : 2);
  writer.integer(static_cast<std::uint8_t>(mode), 1);
  writer.integer(flagsOf(command), 1);
  if (full) writer.integer(0, 2);
  for (const double setPoint : setPoints) writer.integer(toWire(setPoint, mode, form), full ? 4 : 3);
  writer.crc();
  return out.first(writer.size());
}

FrameFault decodeCommand(std::span<const std::uint8_t> bytes, FrameForm form, BoardCommand& command) noexcept {
  const bool full = form == FrameForm::full;
  const FrameFault fault = checkFrame(bytes, full ? FrameType::command : FrameType::packedCommand, commandSize(form));
  if (fault != FrameFault::none) return fault;
  WireReader in(bytes);
  in.skip(kHeadSize);
  BoardCommand decoded;
  decoded.sequence =
      full ? in.unsignedInteger<std::uint32_t>() : nearest16(in.unsignedInteger<std::uint16_t>(), command.sequence);
  decoded.heartbeat =
      full ? in.unsignedInteger<std::uint32_t>() : nearest16(in.unsignedInteger<std::uint16_t>(), command.heartbeat);
  const auto mode = in.unsignedInteger<std::uint8_t>();
  const auto flags = in.unsignedInteger<std::uint8_t>();
  if (mode > static_cast<std::uint8_t>(DriveMode::torque) || (flags & ~kCommandFlags) != 0) return FrameFault::content;
  if (((flags & kEnable) != 0) == ((flags & kBrake) != 0)) return FrameFault::content;
  decoded.drive.mode = static_cast<DriveMode>(mode);
  decoded.drive.enabled = (flags & kEnable) != 0;
  decoded.reset = (flags & kReset) != 0;
  decoded.trip = (flags & kTrip) != 0;
  if (full && in.unsignedInteger<std::uint16_t>() != 0) return FrameFault::content;
  JointVector& setPoints =
      decoded.drive.mode == DriveMode::torque ? decoded.drive.jointTorques : decoded.drive.jointRates;
  for (double& setPoint : setPoints)
    setPoint = fromWire(in.signedInteger<std::int64_t>(full ? 4 : 3), decoded.drive.mode, form);
  command = decoded;
  return FrameFault::none;
}

}  // namespace haptiv::usb
