#pragma once

namespace haptiv {

/// Whether a window could open: the X server of $DISPLAY answers, or, where the user chose it by QT_QPA_PLATFORM,
/// there is a Wayland display. Asked before Qt is, which would end the process.
bool hasDisplay();

}  // namespace haptiv
