#pragma once

#include <QObject>
#include <memory>
#include <thread>

#include "app/session/Falcons.h"

namespace haptiv {

/// Starts a Falcon on a thread of its own: its firmware takes seconds, and homing waits for the operator. Thread: GUI.
class FalconOpening : public QObject {
  Q_OBJECT
 public:
  /// @param period  of the session's ticks [s]
  FalconOpening(const DeviceDescription& description, FalconChoice choice, double period, QObject* parent = nullptr);
  /// Cancels, and waits until the thread has seen it: a second or two at most, while the firmware is brought in.
  ~FalconOpening() override;

  /// After `opened`, once.
  std::unique_ptr<HapticDevice> take() { return std::move(device_); }

 public slots:
  /// Ends in `cancelled`, unless it has ended already.
  void cancel();

 signals:
  /// What the operator has to do.
  void told(const QString& what);
  void opened();
  void failed(const QString& why);
  void cancelled();

 private:
  void run(const std::stop_token& stop, const DeviceDescription& description, FalconChoice choice, double period);
  void endWith(std::unique_ptr<HapticDevice> device, const QString& trouble);

  std::unique_ptr<HapticDevice> device_;
  std::jthread thread_;
};

}  // namespace haptiv
