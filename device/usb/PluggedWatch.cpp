#include "device/usb/PluggedWatch.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace haptiv {

namespace {

constexpr std::chrono::milliseconds kUntilWoken{-1};

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
  {
    const std::lock_guard lock(mutex_);
    firmware_ = falconFirmware;
    wanted_ = true;
  }
  events_.wake();
}

bool PluggedWatch::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  return !listing_;
}

void PluggedWatch::resume() {
  {
    const std::lock_guard lock(mutex_);
    paused_ = false;
  }
  events_.wake();
}

void PluggedWatch::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (!begins()) {
      events_.wait(kUntilWoken);
      continue;
    }
    const Listing listing = list(stop);
    {
      const std::lock_guard lock(mutex_);
      listing_ = false;
    }
    if (!stop.stop_requested()) listed_(listing);
  }
}

/// Whether there is something to list, and it may be.
bool PluggedWatch::begins() {
  const bool arrived = hotPlug_ && std::exchange(hotPlug_->arrived, false);
  const bool departed = hotPlug_ && std::exchange(hotPlug_->departed, false);
  const std::lock_guard lock(mutex_);
  if (arrived || departed) wanted_ = true;
  if (!wanted_ || paused_) return false;
  wanted_ = false;
  return listing_ = true;
}

PluggedWatch::Listing PluggedWatch::list(const std::stop_token& stop) {
  std::string firmware;
  {
    const std::lock_guard lock(mutex_);
    firmware = firmware_;
  }
  try {
    std::vector<PluggedDevice> devices = pluggedDevices(context_, firmware, stop);
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
