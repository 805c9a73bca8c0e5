#include "tests/support/usb/VirtualBus.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "tests/support/usb/PollWatch.h"
#include "tests/support/usb/UsbfsShim.h"

namespace haptiv::test {

namespace {

std::atomic<VirtualBus*> installedBus = nullptr;
constexpr std::chrono::seconds kHang{30};

}  // namespace

VirtualBus::VirtualBus(Clock clock) : clock_(clock) {
  VirtualBus* none = nullptr;
  if (!installedBus.compare_exchange_strong(none, this)) throw std::logic_error("there is a virtual bus already");
}

VirtualBus::~VirtualBus() {
  installedBus = nullptr;
}

VirtualBus* VirtualBus::installed() {
  return installedBus;
}

VirtualPort& VirtualBus::plug(std::shared_ptr<VirtualUsbDevice> device) {
  VirtualPort* port = nullptr;
  {
    const std::lock_guard lock(mutex_);
    port = &ports_.emplace_back(std::move(device), nextAddress_++);
  }
  sysfs_.add(port->descriptors(), port->address());
  settle();
  return *port;
}

void VirtualBus::unplug(VirtualPort& port) {
  {
    const std::lock_guard lock(mutex_);
    port.unplug();
  }
  sysfs_.remove(port.address());
  settle();
}

void VirtualBus::step() {
  const std::lock_guard lock(mutex_);
  std::int64_t interval = 1000;  // as for full speed
  for (VirtualPort& port : ports_) {
    port.tick();
    if (port.plugged()) interval = std::min(interval, port.interval());
  }
  now_ += interval;
  ringAlarms();
}

void VirtualBus::ringAlarms() {
  for (auto alarm = alarms_.begin(); alarm != alarms_.end();) {
    if (alarm->second > now_) {
      ++alarm;
      continue;
    }
    realRing(alarm->first);
    alarm = alarms_.erase(alarm);
  }
}

bool VirtualBus::setAlarm(int descriptor, std::int64_t after) {
  if (clock_ == Clock::wall) return false;
  const std::lock_guard lock(mutex_);
  alarms_[descriptor] = now_ + after;
  return true;
}

void VirtualBus::tick(int intervals) {
  settle();
  for (int i = 0; i < intervals; ++i) {
    step();
    settle();
  }
}

std::vector<int> VirtualBus::awaited() {
  const std::lock_guard lock(mutex_);
  std::vector<int> all;
  for (const VirtualPort& port : ports_)
    for (const int descriptor : port.awaited()) all.push_back(descriptor);
  return all;
}

void VirtualBus::settle() {
  const auto end = std::chrono::steady_clock::now() + kHang;
  while (!pollWatch().quiet(awaited())) {
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error("the host does not come to rest");
    std::this_thread::yield();
  }
}

std::optional<int> VirtualBus::open(const char* path) {
  int bus = 0, address = 0;
  if (std::sscanf(path, "/dev/bus/usb/%d/%d", &bus, &address) != 2) return std::nullopt;
  const std::lock_guard lock(mutex_);
  for (VirtualPort& port : ports_) {
    if (port.address() != address || !port.plugged()) continue;
    return port.permitted ? port.open() : -EACCES;
  }
  return std::nullopt;
}

std::optional<int> VirtualBus::control(int descriptor, unsigned long request, void* argument) {
  const std::lock_guard lock(mutex_);
  for (VirtualPort& port : ports_)
    if (port.has(descriptor)) return port.control(descriptor, request, argument);
  return std::nullopt;
}

void VirtualBus::closing(int descriptor) {
  const std::lock_guard lock(mutex_);
  for (VirtualPort& port : ports_) port.close(descriptor);
  alarms_.erase(descriptor);
}

}  // namespace haptiv::test
