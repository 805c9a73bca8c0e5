#pragma once

#include <QCoreApplication>
#include <QString>

#include "device/usb/PluggedDevices.h"

namespace haptiv {

/// A device in a menu: what it is and which, and what is wrong with it in a word or two.
inline QString textOf(const PluggedDevice& device) {
  QString text = QString::fromStdString(device.product + " " + device.which);
  text.replace('&', "&&");
  if (device.state != PluggedState::usable) text += QString(" - ") + nameOf(device.state);
  return text;
}

/// Behind the name of one that was chosen and has gone.
inline QString notPluggedIn() {
  return QCoreApplication::translate("haptiv::DeviceMenu", " - not plugged in");
}

}  // namespace haptiv
