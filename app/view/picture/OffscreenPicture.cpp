#define GL_GLEXT_PROTOTYPES
#include "app/view/picture/OffscreenPicture.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/system/gl.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "app/view/ViewCamera.h"
#include "app/view/drawn/Background.h"
#include "app/view/drawn/ShapeBoxes.h"
#include "app/view/drawn/StudioLights.h"
#include "app/view/picture/SurfacelessContext.h"

namespace haptiv {
namespace {

constexpr int kSamples = 4;

/// Something to draw on, with depth; current while it lives.
class Canvas {
 public:
  Canvas(int width, int height, int samples) : width_(width), height_(height) {
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glGenRenderbuffers(2, buffers_);
    attach(buffers_[0], samples, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(buffers_[1], samples, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("cannot draw without a window: OpenGL refuses a picture of " + std::to_string(width) +
                               " x " + std::to_string(height) + " pixels; ask for a smaller one");
    }
  }
  ~Canvas() {
    glDeleteFramebuffers(1, &frame_);
    glDeleteRenderbuffers(2, buffers_);
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Copies the other canvas onto this one, averaging its samples.
  void resolve(const Canvas& other) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, other.frame_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  }

  QImage image() const {
    QImage image(width_, height_, QImage::Format_RGBA8888);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
    return image.mirrored().convertToFormat(QImage::Format_RGB32);
  }

 private:
  void attach(GLuint buffer, int samples, GLenum format, GLenum attachment) const {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  }

  int width_;
  int height_;
  GLuint frame_ = 0;
  GLuint buffers_[2] = {};
};

/// Coin warns that there is no GLX wherever EGL draws: true, and of no consequence. Other warnings go where they went.
class QuietAboutGlx {
 public:
  QuietAboutGlx() { SoDebugError::setHandlerCallback(pass, this); }
  ~QuietAboutGlx() { SoDebugError::setHandlerCallback(before_, data_); }
  QuietAboutGlx(const QuietAboutGlx&) = delete;
  QuietAboutGlx& operator=(const QuietAboutGlx&) = delete;

 private:
  static void pass(const SoError* error, void* self) {
    const auto* quiet = static_cast<const QuietAboutGlx*>(self);
    if (!std::strstr(error->getDebugString().getString(), "glxglue")) quiet->before_(error, quiet->data_);
  }

  SoErrorCB* before_ = SoDebugError::getHandlerCallback();
  void* data_ = SoDebugError::getHandlerData();
};

NodeRef<SoSeparator> makeStage(SoNode* root, const SbViewportRegion& region) {
  ViewCamera camera;
  camera.fit(shapeBoxes(root), region.getViewportAspectRatio());

  NodeRef<SoSeparator> stage(new SoSeparator);
  stage->renderCaching = SoSeparator::OFF;
  stage->addChild(makeBackground());
  stage->addChild(camera.root());
  stage->addChild(makeStudioLights());
  stage->addChild(root);
  return stage;
}

}  // namespace

QImage drawOffscreen(SoNode* root, int width, int height) {
  const NodeRef<> kept(root);
  const SbViewportRegion region(static_cast<short>(width), static_cast<short>(height));
  const SurfacelessContext context;
  const QuietAboutGlx quiet;
  GLint mostSamples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &mostSamples);
  const Canvas flat(width, height, 0);
  const Canvas canvas(width, height, std::min(kSamples, mostSamples));
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_NORMALIZE);

  SoGLRenderAction action(region);
  action.setCacheContext(context.coinId());
  action.setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
  action.apply(makeStage(root, region).get());

  flat.resolve(canvas);
  return flat.image();
}

}  // namespace haptiv
