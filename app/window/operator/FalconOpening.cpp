#include "app/window/operator/FalconOpening.h"

#include <exception>
#include <utility>

namespace haptiv {

FalconOpening::FalconOpening(const DeviceDescription& description, FalconChoice choice, double period, QObject* parent)
    : QObject(parent), thread_([=, this](const std::stop_token& stop) { run(stop, description, choice, period); }) {}

FalconOpening::~FalconOpening() {
  thread_.request_stop();
  thread_.join();
}

void FalconOpening::cancel() {
  thread_.request_stop();
}

/// On the thread; what it has to say, the GUI's says.
void FalconOpening::run(const std::stop_token& stop, const DeviceDescription& description, FalconChoice choice,
                        double period) {
  choice.cancelled = [stop] { return stop.stop_requested(); };
  choice.tell = [this](const std::string& what) {
    QMetaObject::invokeMethod(this, [this, text = QString::fromStdString(what)] { emit told(text); });
  };
  auto device = std::make_shared<std::unique_ptr<HapticDevice>>();  // shared: an event is copied
  QString trouble;
  try {
    *device = std::make_unique<FalconDevice>(description, std::move(choice));
    (*device)->start(period);
  } catch (const std::exception& error) {
    device->reset();
    trouble = QString::fromUtf8(error.what());
  }
  QMetaObject::invokeMethod(this, [this, device, trouble] { endWith(std::move(*device), trouble); });
}

void FalconOpening::endWith(std::unique_ptr<HapticDevice> device, const QString& trouble) {
  if (thread_.get_stop_source().stop_requested()) {
    emit cancelled();  // the device, if there is one, ends here
  } else if (device) {
    device_ = std::move(device);
    emit opened();
  } else {
    emit failed(trouble);
  }
}

}  // namespace haptiv

#include "moc_FalconOpening.cpp"
