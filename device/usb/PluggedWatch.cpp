#include "device/usb/PluggedWatch.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace haptiv {

namespace {

constexpr std::chrono::milliseconds kUntilWoken{-1};
constexpr unsigned kListing = 1, kPaused = 2;

/// The same device, not taken out since: another number is given each time that one is plugged in.
bool isSame(const PluggedDevice& a, const PluggedDevice& b) {
  return a.kind == b.kind && a.bus == b.bus && a.address == b.address && a.port == b.port;
}

}  // namespace

PluggedWatch::PluggedWatch(std::function<void(const Listing&)> listed) : listed_(std::move(listed)), events_(context_) {
  if (usb::UsbHotPlug::isAvailable()) hotPlug_.emplace(context_);
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  pthread_setname_np(thread_.native_handle(), "haptiv-plugged");  // for `top -H`
}

PluggedWatch::~PluggedWatch() {
  thread_.request_stop();
  events_.wake();
  thread_.join();
}

void PluggedWatch::look(const std::string& falconFirmware) {
  firmware_.write(falconFirmware);
  events_.wake();
}

bool PluggedWatch::pause() {
  return (state_.fetch_or(kPaused) & kListing) == 0;
}

void PluggedWatch::resume() {
  state_.fetch_and(~kPaused);
  events_.wake();
}

void PluggedWatch::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (!begins()) {
      events_.wait(kUntilWoken);
      continue;
    }
    const Listing listing = list(stop);
    state_.fetch_and(~kListing);
    if (!stop.stop_requested()) listed_(listing);
  }
}

/// Whether there is something to list, and it may be.
bool PluggedWatch::begins() {
  const bool arrived = hotPlug_ && std::exchange(hotPlug_->arrived, false);
  const bool departed = hotPlug_ && std::exchange(hotPlug_->departed, false);
  const bool asked = firmware_.update();
  wanted_ = wanted_ || arrived || departed || asked;
  unsigned rests = 0;
  if (!wanted_ || !state_.compare_exchange_strong(rests, kListing)) return false;
  wanted_ = false;
  return true;
}

PluggedWatch::Listing PluggedWatch::list(const std::stop_token& stop) {
  try {
    std::vector<PluggedDevice> devices = pluggedDevices(context_, firmware_.read(), stop);
    recallSerials(devices);
    last_ = devices;
    return {std::move(devices), {}};
  } catch (const std::exception& error) {
    return {{}, error.what()};
  }
}

/// One that has stopped answering is still the one that it was.
void PluggedWatch::recallSerials(std::vector<PluggedDevice>& devices) {
  for (PluggedDevice& device : devices) {
    if (device.state != PluggedState::silent || !device.serial.empty()) continue;
    const auto before =
        std::find_if(last_.begin(), last_.end(), [&](const PluggedDevice& each) { return isSame(each, device); });
    if (before == last_.end()) continue;
    device.serial = before->serial;
    device.which = before->which;
    device.product = before->product;
  }
}

}  // namespace haptiv
