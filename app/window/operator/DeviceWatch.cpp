#include "app/window/operator/DeviceWatch.h"

#include <QStringList>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/window/operator/DeviceText.h"

namespace haptiv {
namespace {

using Devices = std::vector<PluggedDevice>;

/// Those of `these` that are not among `others`; one that was out and in again has another number.
QStringList without(const Devices& these, const Devices& others, QString (*text)(const PluggedDevice&)) {
  QStringList texts;
  for (const PluggedDevice& device : these) {
    const bool isThere = std::any_of(others.begin(), others.end(), [&](const PluggedDevice& other) {
      return other.bus == device.bus && other.address == device.address;
    });
    if (!isThere) texts += text(device);
  }
  return texts;
}

/// Empty: nothing has come or gone.
QString newsOf(const Devices& before, const Devices& now) {
  const QStringList gone = without(before, now, nameTextOf), come = without(now, before, plainTextOf);
  QStringList news;
  if (!gone.isEmpty()) news += DeviceWatch::tr("Unplugged: %1").arg(gone.join(", "));
  if (!come.isEmpty()) news += DeviceWatch::tr("Plugged in: %1").arg(come.join(", "));
  return news.join("; ");
}

}  // namespace

DeviceWatch::DeviceWatch(QObject* parent) : QObject(parent) {
  look();
}

DeviceWatch::~DeviceWatch() = default;

void DeviceWatch::look() {
  if (start()) watch_->look(firmware_.toStdString());
}

void DeviceWatch::setFirmware(const QString& path) {
  firmware_ = path;
  look();
}

/// Whether there is a watch; where there is none, it is tried anew.
bool DeviceWatch::start() {
  if (watch_) return true;
  try {
    watch_ = std::make_unique<PluggedWatch>([this](const PluggedWatch::Listing& listing) {  // on the watch's thread
      QMetaObject::invokeMethod(
          this, [this, listing] { take(listing); }, Qt::QueuedConnection);
    });
    if (paused_) watch_->pause();
  } catch (const std::exception& error) {
    take({{}, error.what()});
  }
  return watch_ != nullptr;
}

void DeviceWatch::take(const PluggedWatch::Listing& listing) {
  const std::optional<PluggedWatch::Listing> before = std::exchange(known_, listing);
  if (before != known_) emit changed();
  if (before && before->trouble.empty() && listing.trouble.empty())
    if (const QString news = newsOf(before->devices, listing.devices); !news.isEmpty()) emit told(news);
  if (const auto then = std::exchange(then_, nullptr)) then();
}

void DeviceWatch::pauseThen(std::function<void()> then) {
  if (then_) return;
  paused_ = true;
  if (!watch_ || watch_->pause()) return then();
  then_ = std::move(then);
}

void DeviceWatch::resume() {
  if (!std::exchange(paused_, false)) return;
  if (watch_) watch_->resume();
  look();
}

}  // namespace haptiv

#include "moc_DeviceWatch.cpp"
