#pragma once

#include <atomic>
#include <optional>

#include "device/described/DeviceDescription.h"
#include "device/usb/host/BoardRequests.h"
#include "device/usb/host/CommandOutlet.h"
#include "device/usb/host/StateIntake.h"
#include "device/usb/libusb/UsbClient.h"

namespace haptiv::usb {

/// Where a link to an interface board stands.
enum class BoardPhase : std::uint8_t {
  absent,   ///< not there (any more)
  unhomed,  ///< there, but its encoders have no zero: their counts mean nothing
  ready,
};

/// The host's end of the protocol: makes a board ready, takes its states, sends it the servo's commands.
class BoardClient : public UsbClient {
 public:
  /// @param description  of the arm that the board has to drive
  explicit BoardClient(const DeviceDescription& description);

  /// The counts to home the next board by that is opened, if it is not homed; once.
  void homeNext(const std::optional<HomeCounts>& counts) { home_ = counts; }
  /// The servo's [s], by which states are taken; before the link is opened.
  void setPeriod(double period) noexcept { period_ = period; }
  /// The board has been homed. Thread: the link's.
  void homed() noexcept { phase_ = BoardPhase::ready; }

  StreamEndpoints prepare(UsbHandle& handle) override;
  void received(std::span<const std::uint8_t> packet) noexcept override;
  void faulted(TransferEnd end) noexcept override;
  std::size_t send(std::span<std::uint8_t> packet) noexcept override;
  bool awaits() const noexcept override { return outlet_.awaitsEcho(); }
  void skip() noexcept override { outlet_.skip(); }
  void lost() noexcept override;

  // For the servo. Realtime-safe: yes.
  BoardPhase phase() const noexcept { return phase_; }
  std::uint64_t losses() const noexcept { return counters_.losses; }
  bool newest(StateFrame& state) noexcept { return intake_.newest(state); }
  void write(const DeviceCommand& drive, bool reset, bool trip) noexcept { outlet_.write(drive, reset, trip); }

  // Thread: any.
  LinkFigures figures() const noexcept { return counters_.figures(); }
  TimeDistribution latencies() const { return outlet_.latencies(); }
  bool braked() const noexcept { return outlet_.braked(); }
  FrameForm form() const noexcept { return form_; }

 private:
  void expectThisArm(const UsbHandle& handle, const Identity& identity) const;

  DeviceDescription description_;
  double period_ = 0;
  std::optional<HomeCounts> home_;
  LinkCounters counters_;
  StateIntake intake_{counters_};
  CommandOutlet outlet_{counters_};
  std::atomic<FrameForm> form_ = FrameForm::full;
  std::atomic<BoardPhase> phase_ = BoardPhase::absent;
};

}  // namespace haptiv::usb
