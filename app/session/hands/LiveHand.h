#pragma once

#include <memory>

#include "device/simulated/Hand.h"
#include "device/realtime/TripleBuffer.h"

namespace haptiv {

/// A hand that another thread moves, as the mouse does. The seam is shared: the session writes, the device reads.
class LiveHand : public HandSource {
 public:
  using Seam = TripleBuffer<HandTarget>;
  explicit LiveHand(std::shared_ptr<Seam> seam) : seam_(std::move(seam)) {}

  HandTarget at(double) noexcept override {
    seam_->update();
    return seam_->read();
  }

 private:
  std::shared_ptr<Seam> seam_;
};

}  // namespace haptiv
