#include "scenegraph/reading/coin/NurbsContext.h"

#include <Inventor/C/glue/gl.h>

namespace haptiv {
namespace {

/// Any address but null.
cc_glglue_offscreen_data create(unsigned int, unsigned int) {
  static char nothing = 0;
  return &nothing;
}

SbBool makeCurrent(cc_glglue_offscreen_data) {
  return TRUE;
}

void ignore(cc_glglue_offscreen_data) {}

}  // namespace

void cutNurbsWithoutDisplay() {
  static cc_glglue_offscreen_cb_functions functions{&create, &makeCurrent, &ignore, &ignore};  // Coin keeps the pointer
  cc_glglue_context_set_offscreen_cb_functions(&functions);
}

}  // namespace haptiv
