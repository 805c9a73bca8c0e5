#include "app/commands/Display.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <string_view>

namespace haptiv {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

bool hasDisplay() {
  if (environment("QT_QPA_PLATFORM").starts_with("wayland")) return !environment("WAYLAND_DISPLAY").empty();
  if (environment("DISPLAY").empty()) return false;
  Display* display = XOpenDisplay(nullptr);
  if (display) XCloseDisplay(display);
  return display != nullptr;
}

}  // namespace haptiv
