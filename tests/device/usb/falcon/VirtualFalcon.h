#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "device/described/DeviceDescription.h"
#include "device/simulated/SimulatedArm.h"
#include "device/usb/falcon/FalconPackets.h"

namespace haptiv::falcon::test {

/// A Falcon as its USB side sees it: the serial chip's requests, the loader behind it, the firmware, and the simulated
/// arm with a hand. Its time goes on by a millisecond with each order. What it does is what docs/falcon.md says that
/// others have seen: it proves that the driver keeps to that, not that a Falcon does.
class VirtualFalcon {
 public:
  enum class Stage { off, asked, loading, running };

  /// How it differs from a whole one.
  struct Faults {
    int loaderSilent = 0;             ///< times that the loader does not answer
    bool longAnswer = false;          ///< the loader's answers have one more byte in front
    std::ptrdiff_t echoWrongAt = -1;  ///< this byte of the firmware comes back changed
    bool firmwareDead = false;        ///< it does not answer
    bool homesByItself = true;        ///< false: only once each leg has been beyond kHomingAngle
    bool operatorHomes = false;       ///< pulls the grip out for that, and then lets go of it
    std::uint8_t unhomed = 0;         ///< bit i: leg i loses its zero
    int answersLost = 0;              ///< so many answers to orders are lost
    int answersDamaged = 0;           ///< so many have a wrong byte
  };
  static constexpr double kHomingAngle = 1;  ///< of the upper arms, where the grip is pulled out [rad]

  explicit VirtualFalcon(const DeviceDescription& description, std::size_t firmwareSize = 4096);

  /// A request to the chip. False: there is no such one, a stall.
  bool control(std::uint8_t request, std::uint16_t value, std::uint16_t index);
  /// Bytes to the OUT endpoint.
  void take(std::span<const std::uint8_t> bytes);
  /// One packet of the IN endpoint: the chip's two status bytes, and what there is to tell.
  std::vector<std::uint8_t> tell();
  bool hasToTell() const { return !told_.empty(); }

  void setHand(const HandTarget& target) { hand_ = target; }
  void setButtons(std::uint8_t buttons) { buttons_ = buttons; }
  Faults& faults() { return faults_; }
  Stage stage() const { return stage_; }
  const Order& lastOrder() const { return order_; }
  std::uint64_t orders() const { return orders_; }
  std::int16_t largestMotor() const { return largestMotor_; }
  const std::vector<std::uint8_t>& firmware() const { return firmware_; }
  const SimulatedArm& arm() const { return arm_; }

 private:
  void takeOfLoader(std::uint8_t byte);
  void takeOfFirmware(std::uint8_t byte);
  void follow(const Order& order);
  void answer();
  void say(std::span<const std::uint8_t> bytes) { told_.insert(told_.end(), bytes.begin(), bytes.end()); }

  DeviceDescription description_;
  SimulatedArm arm_;
  std::size_t firmwareSize_;
  Faults faults_;
  Stage stage_ = Stage::off;
  unsigned baud_ = 0;  // the divisor's value and index
  std::deque<std::uint8_t> told_;
  std::vector<std::uint8_t> heard_, firmware_;
  HandTarget hand_;
  std::uint8_t buttons_ = 0;
  std::uint8_t homed_ = 0;
  Order order_;
  std::uint64_t orders_ = 0;
  std::int16_t largestMotor_ = 0;
};

}  // namespace haptiv::falcon::test
