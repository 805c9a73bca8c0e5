#include "app/figures/OffscreenQt.h"

#include <QApplication>
#include <array>
#include <string>

namespace haptiv {

/// What Qt keeps a hold of, and strikes out as it reads.
struct OffscreenQt::Arguments {
  std::string name = "haptiv", key = "-platform", value = "offscreen";
  std::array<char*, 4> list = {name.data(), key.data(), value.data(), nullptr};
  int count = 3;
};

namespace {

QtMessageHandler before = nullptr;

/// Where a machine gives its users no folder for sockets, Qt says so, to no use here. Other warnings go where they
/// went.
void quietAboutRuntimeFolder(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  if (before && !message.contains("XDG_RUNTIME_DIR")) before(type, context, message);
}

}  // namespace

OffscreenQt::OffscreenQt() : arguments_(std::make_unique<Arguments>()) {
  if (QCoreApplication::instance()) return;
  before = qInstallMessageHandler(quietAboutRuntimeFolder);
  application_ = std::make_unique<QApplication>(arguments_->count, arguments_->list.data());
  qInstallMessageHandler(before);
}

OffscreenQt::~OffscreenQt() = default;

}  // namespace haptiv
