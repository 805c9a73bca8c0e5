#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>

#include "device/usb/PluggedWatch.h"

namespace haptiv {

/// What is plugged in, as the window knows it: it is listed on a thread of its own, and comes here by the event loop.
/// Listed from the start, whenever something is plugged in or out, and whenever `look` asks for it. Thread: GUI.
class DeviceWatch : public QObject {
  Q_OBJECT
 public:
  explicit DeviceWatch(QObject* parent = nullptr);
  /// Waits, a second at most, for a device that is being asked and does not answer.
  ~DeviceWatch() override;

  /// As it was listed last; nothing: it has not been yet.
  const std::optional<PluggedWatch::Listing>& known() const { return known_; }

  void look();
  /// The Falcon's firmware, whose absence is told; empty: where it is looked for.
  void setFirmware(const QString& path);

  /// Does `then` when no device is being asked, mostly at once; and asks none until `resume`: a device that is asked
  /// cannot be opened. While another waits for that: nothing.
  void pauseThen(std::function<void()> then);
  /// What may have changed meanwhile is listed. Not paused: nothing.
  void resume();

 signals:
  /// The list is another one than before.
  void changed();
  /// Something has been plugged in or out: a line for the user.
  void told(const QString& what);

 private:
  bool start();
  void take(const PluggedWatch::Listing& listing);

  std::optional<PluggedWatch::Listing> known_;
  QString firmware_;
  bool paused_ = false;
  std::function<void()> then_;
  std::unique_ptr<PluggedWatch> watch_;  // null: libusb could not be started
};

}  // namespace haptiv
