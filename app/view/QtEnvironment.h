#pragma once

namespace haptiv {

/// Sets the environment variables that Qt, SoQt and Mesa read when they start: no display scaling (SoQt maps the mouse
/// wrongly under it), X11 rather than Wayland unless the user says otherwise, and software drawing on one core so that
/// the servo keeps the others. Call before QApplication is made.
void prepareQtEnvironment();

/// Whether OpenGL is drawn by the processor (llvmpipe and the like), where multisampling costs too much.
/// Needs a QApplication.
bool drawsInSoftware();

}  // namespace haptiv
