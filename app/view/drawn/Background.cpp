#include "app/view/drawn/Background.h"

#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/system/gl.h>

namespace haptiv {
namespace {

constexpr float kTop[] = {0.97F, 0.98F, 0.99F};
constexpr float kBottom[] = {0.80F, 0.84F, 0.88F};

void drawQuad() {
  glBegin(GL_QUADS);
  glColor3fv(kBottom);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glColor3fv(kTop);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
  glEnd();
}

void draw(void*, SoAction* action) {
  if (!action->isOfType(SoGLRenderAction::getClassTypeId())) return;
  glPushAttrib(GL_ENABLE_BIT | GL_DEPTH_BUFFER_BIT | GL_CURRENT_BIT | GL_LIGHTING_BIT | GL_TRANSFORM_BIT);
  glDisable(GL_LIGHTING);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glShadeModel(GL_SMOOTH);
  glMatrixMode(GL_PROJECTION);
  glPushMatrix();
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glLoadIdentity();
  drawQuad();
  glPopMatrix();
  glMatrixMode(GL_PROJECTION);
  glPopMatrix();
  glPopAttrib();
  SoGLLazyElement::getInstance(action->getState())->reset(action->getState(), SoLazyElement::ALL_MASK);
}

}  // namespace

// In a separator: a bare callback would be called again, over all that was drawn, for each path of the transparent
// pass.
SoNode* makeBackground() {
  auto* separator = new SoSeparator;
  separator->renderCaching = SoSeparator::OFF;
  auto* callback = new SoCallback;
  callback->setCallback(draw);
  separator->addChild(callback);
  return separator;
}

}  // namespace haptiv
