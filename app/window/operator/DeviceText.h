#pragma once

#include <QCoreApplication>
#include <QString>

#include "device/usb/PluggedDevices.h"

namespace haptiv {

/// What a device is, and which.
inline QString nameTextOf(const PluggedDevice& device) {
  return QString::fromStdString(device.product + " " + device.which);
}

/// Behind it: what is wrong with it in a word or two, or nothing.
inline QString stateTextOf(const PluggedDevice& device) {
  return device.state == PluggedState::usable ? QString() : QString(" - ") + nameOf(device.state);
}

inline QString plainTextOf(const PluggedDevice& device) {
  return nameTextOf(device) + stateTextOf(device);
}

/// As an item of a menu.
inline QString textOf(const PluggedDevice& device) {
  return plainTextOf(device).replace('&', "&&");
}

/// In place of a list that is on its way.
inline QString lookingForDevices() {
  return QCoreApplication::translate("haptiv::DeviceMenu", "Looking for devices...");
}

/// Behind the name of one that was chosen and has gone.
inline QString notPluggedIn() {
  return QCoreApplication::translate("haptiv::DeviceMenu", " - not plugged in");
}

}  // namespace haptiv
