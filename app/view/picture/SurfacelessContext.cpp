#include "app/view/picture/SurfacelessContext.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

#include <QOpenGLContext>
#include <stdexcept>
#include <string>

namespace haptiv {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("cannot draw without a window: " + what +
                           "; install the packages libegl-mesa0 and libgl1-mesa-dri");
}

EGLDisplay openDisplay() {
  const auto getDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!getDisplay) fail("EGL knows no platforms");
  EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) fail("EGL has no surfaceless display");
  return display;
}

EGLContext makeContext(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) {
    fail("EGL has no desktop OpenGL");
  }
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (context == EGL_NO_CONTEXT) fail("EGL makes no OpenGL context");
  return context;
}

}  // namespace

SurfacelessContext::SurfacelessContext() {
  if (QOpenGLContext* current = QOpenGLContext::currentContext()) current->doneCurrent();
  display_ = openDisplay();
  context_ = makeContext(display_);
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
    eglDestroyContext(display_, context_);
    fail("EGL draws only on surfaces");
  }
  coinId_ = SoGLCacheContextElement::getUniqueCacheContext();
}

// The display stays open: it is shared by all of the process, and so is what Mesa keeps with it.
SurfacelessContext::~SurfacelessContext() {
  SoContextHandler::destructingContext(coinId_);
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace haptiv
